// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PCLPointCloud2.h>

#include <string>
#include <string_view>

namespace pcl_normal_smoothing
{
namespace tools
{
/** Bytes of one number of a pcl::PCLPointField datatype; 0 for a datatype that PCL does not know. */
std::size_t
sizeOfType (std::uint8_t datatype);

/** Reads a number from text that holds nothing else.
  * \param[out] value where its sizeOfType (datatype) bytes go
  * \return false where the text is no such number */
bool
parseValue (std::string_view text, std::uint8_t datatype, std::uint8_t* value);

/** A number as the nearest double; 0 for a datatype that PCL does not know. */
double
numberOf (const std::uint8_t* value, std::uint8_t datatype);

/** Appends a number as the shortest text that reads back to the same bits (NaN: as "nan"). */
void
appendValue (const std::uint8_t* value, std::uint8_t datatype, std::string& text);

/** Appends a float as the shortest text that reads back to the same bits. */
void
appendFloat (float value, std::string& text);

/** The next word of \a text, which loses it; empty where there is none. Spaces, tabs, line ends part words. */
std::string_view
nextWord (std::string_view& text);

/** The next line of \a text, which loses it, without its line end. */
std::string_view
nextLine (std::string_view& text);

/** A whole number from a word. \return false where it is none or too large */
bool
parseCount (std::string_view word, std::uint64_t& count);

/** The field of that name; nullptr where there is none. */
const pcl::PCLPointField*
findField (const pcl::PCLPointCloud2& cloud, const std::string& name);

/** Adds float fields that the cloud does not have yet, with NaN in every point. */
void
addFloatFields (pcl::PCLPointCloud2& cloud, const std::vector<std::string>& names);
} // namespace tools
} // namespace pcl_normal_smoothing
