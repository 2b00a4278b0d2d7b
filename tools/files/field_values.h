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

/** Parses a text that consists of one number.
  * \param[out] value receives sizeOfType (datatype) bytes
  * \return false if the text is not such a number */
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

/** Removes the next word from \a text and returns it; empty if there is none. White space separates words. */
std::string_view
nextWord (std::string_view& text);

/** Removes the next line from \a text and returns it without its line end. */
std::string_view
nextLine (std::string_view& text);

/** Parses a whole number. \return false if the word is not one, or the number is too large */
bool
parseCount (std::string_view word, std::uint64_t& count);

/** The field of that name; nullptr if there is none. */
const pcl::PCLPointField*
findField (const pcl::PCLPointCloud2& cloud, const std::string& name);

/** Adds those float fields that the cloud lacks, with NaN at every point. */
void
addFloatFields (pcl::PCLPointCloud2& cloud, const std::vector<std::string>& names);
} // namespace tools
} // namespace pcl_normal_smoothing
