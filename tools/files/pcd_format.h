// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "output_file.h"
#include "point_stream.h"
#include "tool_error.h"

namespace pcl_normal_smoothing
{
namespace tools
{
/** Reads the bytes of a PCD file; its padding fields "_" become gaps between the others. \throw FormatError */
void
readPcd (const std::string& bytes, CloudFile& file);

/** Reads the points of a PCD file.
  * \param[in] most limit on the points that its header may claim
  * \return nullptr for a compressed file, which is stored field by field \throw FormatError */
std::unique_ptr<PointReader>
makePcdReader (ByteStream& stream, std::uint64_t most);

/** \throw FormatError if the format cannot hold the cloud */
void
writePcd (const CloudFile& file, FileFormat format, OutputFile& output);

/** The header; in an uncompressed file, writePcdPoints writes the rest. */
std::string
pcdHeader (const CloudShape& shape, FileFormat format);

/** \param[in] data shape.point_step bytes per point */
void
writePcdPoints (const CloudShape& shape,
                FileFormat format,
                const std::uint8_t* data,
                std::size_t points,
                OutputFile& output);
} // namespace tools
} // namespace pcl_normal_smoothing
