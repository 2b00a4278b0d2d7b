// SPDX-License-Identifier: BSD-3-Clause
#include "pcd_format.h"

#include "field_values.h"

#include <lzf.h>
#include <pcl/common/io.h>

#include <algorithm>
#include <array>
#include <cstring>

namespace pcl_normal_smoothing
{
namespace tools
{
namespace
{
using Fields = std::vector<pcl::PCLPointField>;

/** What the lines before the data say. */
struct Header
{
  Fields fields;                    // with the padding "_"
  std::vector<std::uint64_t> sizes; // bytes per number, from SIZE
  std::uint64_t width = 0, height = 1, points = 0;
  bool has_points = false;
  std::size_t stride = 0;
  std::array<float, 7> viewpoint {0, 0, 0, 1, 0, 0, 0};
  std::string encoding;
};

std::uint64_t
countFrom (std::string_view word, const char* key)
{
  std::uint64_t count = 0;
  if (!parseCount (word, count))
    throw FormatError (std::string (key) + " of its header is no whole number (" + std::string (word) + ")");
  return count;
}

/** Calls \a use (field number, word) for every field. */
template <typename Use>
void
forEachField (const Header& header, std::string_view line, const char* key, const Use& use)
{
  for (std::size_t i = 0; i < header.fields.size (); ++i) {
    const std::string_view word = nextWord (line);
    if (word.empty ())
      throw FormatError (std::string (key) + " of its header has fewer entries than FIELDS");
    use (i, word);
  }
}

void
readFieldLine (std::string_view key, std::string_view line, Header& header)
{
  if (key == "FIELDS" || key == "COLUMNS") {
    for (std::string_view name = nextWord (line); !name.empty (); name = nextWord (line)) {
      header.fields.emplace_back ();
      header.fields.back ().name = name;
      header.fields.back ().datatype = pcl::PCLPointField::FLOAT32;
      header.fields.back ().count = 1;
    }
    header.sizes.assign (header.fields.size (), 4);
  }
  else if (key == "SIZE")
    forEachField (header, line, "SIZE", [&] (std::size_t i, auto word) { header.sizes[i] = countFrom (word, "SIZE"); });
  else if (key == "TYPE")
    forEachField (header, line, "TYPE", [&] (std::size_t i, std::string_view word) {
      const int type = header.sizes[i] <= 8 ? pcl::getFieldType (static_cast<int> (header.sizes[i]), word[0]) : -1;
      if (type < 0)
        throw FormatError ("SIZE and TYPE of field " + header.fields[i].name + " of its header make no type");
      header.fields[i].datatype = static_cast<std::uint8_t> (type);
    });
  else if (key == "COUNT")
    forEachField (header, line, "COUNT", [&] (std::size_t i, std::string_view word) {
      const std::uint64_t count = countFrom (word, "COUNT");
      if (count > max_point_bytes)
        throw FormatError ("COUNT of field " + header.fields[i].name + " of its header is too large");
      header.fields[i].count = static_cast<pcl::uindex_t> (count);
    });
}

/** \return whether this was the last line */
bool
readHeaderLine (std::string_view line, Header& header)
{
  const std::string_view key = nextWord (line);
  if (key == "WIDTH")
    header.width = countFrom (nextWord (line), "WIDTH");
  else if (key == "HEIGHT")
    header.height = countFrom (nextWord (line), "HEIGHT");
  else if (key == "POINTS") {
    header.points = countFrom (nextWord (line), "POINTS");
    header.has_points = true;
  }
  else if (key == "VIEWPOINT")
    for (float& number : header.viewpoint) {
      if (!parseValue (nextWord (line), pcl::PCLPointField::FLOAT32, reinterpret_cast<std::uint8_t*> (&number)))
        throw FormatError ("VIEWPOINT of its header does not hold seven numbers");
    }
  else if (key == "DATA")
    header.encoding = nextWord (line);
  else
    readFieldLine (key, line, header);
  return key == "DATA";
}

/** Reads the header; the stream then continues with the data. */
Header
readHeader (ByteStream& stream, std::uint64_t most)
{
  Header header;
  bool complete = false;
  while (!complete && stream.left () > 0) {
    // Recognise another kind of file by its first lines, without searching all of it for DATA.
    const std::string_view first = stream.peek (4096).substr (0, 4096);
    if (header.fields.empty () && first.find ("FIELDS") == std::string_view::npos &&
        first.find ("COLUMNS") == std::string_view::npos)
      break;
    complete = readHeaderLine (nextLine (stream), header);
  }
  if (!complete || header.fields.empty ())
    throw FormatError ("is no PCD file, its header lacks FIELDS or DATA");
  if (header.has_points && header.width == 0 && header.height <= 1)
    header.width = header.points;
  if (header.width > most || header.height > most || (header.height > 0 && header.width > most / header.height))
    throw FormatError ("its header claims more points than PCL can count");
  if (header.has_points && header.points != header.width * header.height)
    throw FormatError ("WIDTH times HEIGHT of its header is not POINTS");
  header.points = header.width * header.height;
  if (header.encoding == "binary_compressed") // holds no padding
    header.fields.erase (std::remove_if (header.fields.begin (), header.fields.end (),
                                         [] (const auto& field) { return field.name == "_"; }),
                         header.fields.end ());
  for (std::size_t i = 0; i < header.fields.size (); ++i) {
    header.fields[i].offset = static_cast<pcl::uindex_t> (header.stride);
    header.stride += header.fields[i].count * sizeOfType (header.fields[i].datatype);
    if (header.stride > max_point_bytes)
      throw FormatError ("its header claims points of more than 16 megabytes");
  }
  return header;
}

void
requireBytes (std::uint64_t available, std::uint64_t points, std::uint64_t bytes_per_point)
{
  if (bytes_per_point > 0 && points > available / bytes_per_point)
    throw FormatError ("is truncated, it holds less than the " + std::to_string (points) +
                       " points that its header claims");
}

/** Reads a point from the next line that is not empty. */
void
readAsciiPoint (ByteStream& stream, const Header& header, std::uint64_t i, std::uint8_t* point)
{
  std::string_view line;
  while (line.find_first_not_of (" \t") == std::string_view::npos && stream.left () > 0)
    line = nextLine (stream);
  for (const auto& field : header.fields) {
    std::uint8_t* value = point + field.offset;
    const std::size_t size = sizeOfType (field.datatype);
    for (std::size_t c = 0; c < field.count; ++c, value += size) {
      const std::string_view word = nextWord (line);
      if (!parseValue (word, field.datatype, value))
        throw FormatError ("field " + field.name + " of point " + std::to_string (i) +
                           (word.empty () ? " is missing" : " is no number of its type (" + std::string (word) + ")"));
    }
  }
  if (!nextWord (line).empty ())
    throw FormatError ("the line of point " + std::to_string (i) + " has more values than there are fields");
}

/** Reads two sizes, then an LZF block of all values of the first field, all of the second, and so on. */
void
readCompressed (std::string_view bytes, const Header& header, std::vector<std::uint8_t>& data)
{
  std::uint32_t sizes[2] = {0, 0};
  if (bytes.size () < sizeof sizes)
    throw FormatError ("is truncated, it ends before its data");
  std::memcpy (sizes, bytes.data (), sizeof sizes);
  bytes.remove_prefix (sizeof sizes);
  std::uint64_t expected = 0;
  for (const auto& field : header.fields)
    expected += header.points * field.count * sizeOfType (field.datatype);
  // LZF expands 3 bytes to at most 264.
  if (sizes[0] > bytes.size () || sizes[1] != expected || expected / 88 > sizes[0])
    throw FormatError ("is truncated or damaged, its compressed data do not have the size that its header claims");
  std::vector<std::uint8_t> columns (expected);
  if (expected > 0 && lzf_decompress (bytes.data (), sizes[0], columns.data (), sizes[1]) != expected)
    throw FormatError ("its compressed data are damaged");
  data.resize (header.points * header.stride);
  const std::uint8_t* from = columns.data ();
  for (const auto& field : header.fields) {
    const std::size_t size = field.count * sizeOfType (field.datatype);
    for (std::size_t i = 0; i < header.points && size > 0; ++i, from += size)
      std::memcpy (data.data () + i * header.stride + field.offset, from, size);
  }
}
class PcdReader : public PointReader
{
public:
  PcdReader (ByteStream& stream, const Header& header) : stream_ (stream), header_ (header)
  {
    for (const auto& field : header.fields)
      if (field.name != "_" && field.count > 0)
        shape_.fields.push_back (field);
    shape_.point_step = header.stride;
    shape_.width = header.width;
    shape_.height = header.height;
    const auto& v = header.viewpoint;
    shape_.origin = Eigen::Vector4f (v[0], v[1], v[2], 0);
    shape_.orientation = Eigen::Quaternionf (v[3], v[4], v[5], v[6]);
    if (header.encoding == "binary")
      requireBytes (stream.left (), header.points, header.stride);
    else if (header.encoding == "ascii") {
      std::size_t words = 0;
      for (const auto& field : header.fields)
        words += field.count;
      requireBytes (stream.left () + 1, header.points, 2 * words); // a character and a separator per word
    }
    else if (header.encoding != "binary_compressed")
      throw FormatError ("DATA of its header is neither ascii nor binary nor binary_compressed");
  }

  std::size_t
  read (std::size_t most, std::vector<std::uint8_t>& data) override
  {
    const std::size_t count = nextCount (most);
    if (header_.encoding == "binary") {
      const std::string_view bytes = stream_.peek (count * header_.stride);
      requireBytes (bytes.size (), count, header_.stride);
      data.assign (bytes.begin (), bytes.begin () + static_cast<std::ptrdiff_t> (count * header_.stride));
      stream_.skip (count * header_.stride);
    }
    else {
      data.assign (count * header_.stride, 0);
      for (std::size_t i = 0; i < count; ++i)
        readAsciiPoint (stream_, header_, done_ + i, data.data () + i * header_.stride);
    }
    done_ += count;
    return count;
  }

private:
  ByteStream& stream_;
  Header header_;
};
} // namespace

std::unique_ptr<PointReader>
makePcdReader (ByteStream& stream, std::uint64_t most)
{
  const Header header = readHeader (stream, most);
  if (header.encoding == "binary_compressed")
    return nullptr;
  return std::make_unique<PcdReader> (stream, header);
}

void
readPcd (const std::string& bytes, CloudFile& file)
{
  ByteStream stream {std::string_view (bytes)};
  const Header header = readHeader (stream, max_cloud_size);
  PcdReader reader (stream, header);
  if (header.encoding == "binary_compressed")
    readCompressed (stream.peek (), header, file.cloud->data);
  else
    reader.read (header.points, file.cloud->data);
  setShape (reader.shape (), file);
}
} // namespace tools
} // namespace pcl_normal_smoothing
