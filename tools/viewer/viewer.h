// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "viewer/parameters.h"
#include "viewer/window.h"

namespace pcl_normal_smoothing
{
namespace tools
{
/** Where the keys that write files write to. */
struct ViewerOutputs
{
  std::string cloud; // empty: the key says so
  FileFormat format = FileFormat::BINARY;
};

/** What lies between keys, smoothing and window. */
class Viewer
{
public:
  /** Smooths with the parameters and shows it. */
  Viewer (ViewerSession& session,
          const ViewerParameters& parameters,
          ViewerWindow& window,
          Colouring colouring,
          const ViewerOutputs& outputs);

  /** Does what a key stands for; the window shows it, or what is wrong. */
  void
  press (const std::string& key);

  void
  savePicture (const std::string& path);

  /** What the keys do, a line each. */
  static std::string
  help ();

private:
  void
  smooth ();

  void
  nextColouring ();

  void
  saveSmoothed ();

  /** Keys that leave the parameters alone. \return whether it is one */
  bool
  pressOther (const std::string& key);

  void
  show ();

  ViewerSession& session_;
  ViewerParameters parameters_;
  ViewerWindow& window_;
  Colouring colouring_;
  ViewerOutputs outputs_;
  bool help_ = false;
  std::string message_;
};
} // namespace tools
} // namespace pcl_normal_smoothing
