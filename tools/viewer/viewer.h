// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "viewer/parameters.h"
#include "viewer/window.h"

namespace pcl_normal_smoothing
{
namespace tools
{
/** Where keys save files. */
struct ViewerOutputs
{
  std::string cloud; // empty: the key shows a message instead
  FileFormat format = FileFormat::BINARY;
};

/** Connects the keys, the smoothing and the window. */
class Viewer
{
public:
  /** Smooths with the parameters and shows the result. */
  Viewer (ViewerSession& session,
          const ViewerParameters& parameters,
          ViewerWindow& window,
          Colouring colouring,
          const ViewerOutputs& outputs);

  /** Does what a key stands for; the window shows the result, or what is wrong. */
  void
  press (const std::string& key);

  void
  savePicture (const std::string& path);

  /** What the keys do, one per line. */
  static std::string
  help ();

private:
  void
  smooth ();

  void
  nextColouring ();

  void
  saveSmoothed ();

  /** Handles the keys that leave the parameters alone. \return whether \a key is one of them */
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
