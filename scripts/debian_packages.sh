#!/usr/bin/env bash
# Sourced by the scripts that install packages.

# install_packages "package|what it is for"...
# Installs what this machine lacks. Does nothing, and needs no network, if nothing is missing.
install_packages ()
{
  local line missing=()
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    echo "Not a Debian system: nothing is installed here. What is needed, under Debian's names:" >&2
    printf '  %s\n' "${@/|/: }" >&2
    return 0
  fi
  for line in "$@"; do
    if [ "$(dpkg-query -W -f '${db:Status-Status}' "${line%%|*}" 2>/dev/null)" != installed ]; then
      echo "Installing ${line%%|*}: ${line#*|}"
      missing+=("${line%%|*}")
    fi
  done
  [ ${#missing[@]} -gt 0 ] || return 0
  local as_root=(env)
  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null || { echo "Cannot install packages: run this as root, or install sudo." >&2; return 1; }
    as_root=(sudo env)
  fi
  "${as_root[@]}" DEBIAN_FRONTEND=noninteractive apt-get update -q
  "${as_root[@]}" DEBIAN_FRONTEND=noninteractive apt-get install -q -y --no-install-recommends "${missing[@]}"
}
