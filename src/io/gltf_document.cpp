// SPDX-License-Identifier: MIT
#include "io/gltf_document.hpp"

#include <algorithm>
#include <array>

#include "convexact/error.hpp"
#include "convexact/io.hpp"
#include "io/base64.hpp"
#include "io/binary_cursor.hpp"
#include "io/file_beside.hpp"
#include "number/text.hpp"

namespace convexact {
namespace {

using nlohmann::json;

constexpr std::uint64_t kAnyUnsigned = ~std::uint64_t{0};

// An integer of an object that may lack it.
std::uint64_t unsigned_or(const json& object, const char* key, std::uint64_t missing,
                          const std::string& where) {
  const auto found = object.find(key);
  if (found == object.end()) return missing;
  return gltf_unsigned(*found, kAnyUnsigned, where + "." + key);
}

const json& required(const json& object, const char* key, const std::string& where) {
  const auto found = object.find(key);
  if (found == object.end()) gltf_fail(where, std::string("a member ") + key);
  return *found;
}

// The bytes [offset, offset + size) of `bytes`. What files say may exceed std::size_t.
std::string_view slice(std::string_view bytes, std::uint64_t offset, std::uint64_t size,
                       const std::string& where) {
  if (offset > bytes.size() || size > bytes.size() - offset) {
    gltf_fail(where, counted(size, "byte", "bytes") + " from byte " + std::to_string(offset) +
                         " on, found " + counted(bytes.size(), "byte", "bytes") + " in all");
  }
  return bytes.substr(static_cast<std::size_t>(offset), static_cast<std::size_t>(size));
}

constexpr unsigned kByte = 5120, kUnsignedByte = 5121, kShort = 5122, kUnsignedShort = 5123,
                   kUnsignedInt = 5125, kFloat = 5126;

std::size_t size_of_component(unsigned type, const std::string& where) {
  switch (type) {
    case kByte:
    case kUnsignedByte:
      return 1;
    case kShort:
    case kUnsignedShort:
      return 2;
    case kUnsignedInt:
    case kFloat:
      return 4;
    default:
      gltf_fail(where + ".componentType",
                "5120, 5121, 5122, 5123, 5125 or 5126, found " + std::to_string(type));
  }
}

// Extensions that say nothing about where points are. Those of materials, textures and lights are
// recognised by how they begin.
bool is_harmless(std::string_view extension) {
  constexpr std::array kNames = {"KHR_mesh_quantization", "KHR_xmp_json_ld",
                                 "KHR_animation_pointer", "EXT_lights_image_based",
                                 "MSFT_texture_dds"};
  constexpr std::array kBegin = {"KHR_materials_", "KHR_texture_",   "KHR_lights_",
                                 "EXT_texture_",   "EXT_materials_", "ADOBE_materials_"};
  return std::find(kNames.begin(), kNames.end(), extension) != kNames.end() ||
         std::any_of(kBegin.begin(), kBegin.end(),
                     [&](const char* begin) { return extension.starts_with(begin); });
}

}  // namespace

std::string gltf_place(const std::string& list, std::size_t index) {
  return list + "[" + std::to_string(index) + "]";
}

void gltf_fail(const std::string& where, const std::string& expected, ErrorCode code) {
  throw Error(code, where + ": expected " + expected);
}

std::uint64_t gltf_unsigned(const json& value, std::uint64_t limit, const std::string& where) {
  // Below a spelled key, an integer is its text.
  if (!value.is_number_unsigned() || value.get<std::uint64_t>() >= limit) {
    gltf_fail(where, "an integer from 0" +
                         (limit == kAnyUnsigned ? "" : " to " + std::to_string(limit - 1)) +
                         ", found " + in_quotes(dump_json(value)));
  }
  return value.get<std::uint64_t>();
}

std::size_t GltfAccessor::component_size() const { return size_of_component(type, where); }

double GltfAccessor::stored(std::size_t element, std::size_t component) const {
  const auto replaced = replaced_.find(element);
  const bool is_replaced = replaced != replaced_.end();
  if (!is_replaced && bytes_.empty()) return 0;
  const std::string_view bytes = is_replaced ? replaced->second : bytes_;
  const std::size_t offset = (is_replaced ? 0 : element * stride_) + component * component_size();
  BinaryCursor cursor(bytes, offset, ByteOrder::Little);
  switch (type) {
    case kByte:
      return static_cast<std::int8_t>(cursor.take<std::uint8_t>());
    case kUnsignedByte:
      return cursor.take<std::uint8_t>();
    case kShort:
      return static_cast<std::int16_t>(cursor.take<std::uint16_t>());
    case kUnsignedShort:
      return cursor.take<std::uint16_t>();
    case kUnsignedInt:
      return cursor.take<std::uint32_t>();
    default:
      return cursor.take_float();
  }
}

long GltfAccessor::divisor() const {
  if (!is_normalized || type == kFloat || type == kUnsignedInt) return 1;
  return type == kByte ? 127 : type == kUnsignedByte ? 255 : type == kShort ? 32767 : 65535;
}

GltfDocument::GltfDocument(std::string_view bytes, std::string folder)
    : folder_(std::move(folder)), total_bytes_(bytes.size()) {
  read_container(bytes);
  if (!root_.is_object()) gltf_fail("glTF", "an object");
  const std::string version = root_.contains("asset") && root_["asset"].is_object() &&
                                      root_["asset"].contains("version") &&
                                      root_["asset"]["version"].is_string()
                                  ? root_["asset"]["version"].get<std::string>()
                                  : "";
  if (!version.starts_with("2.")) {
    gltf_fail("asset.version", "glTF 2.0, found " + in_quotes(version), ErrorCode::Unreadable);
  }
  require_known_extensions();
}

// A .glb is a header of 12 bytes, a chunk of JSON, and one of bytes. (Section 4.4.)
void GltfDocument::read_container(std::string_view bytes) {
  constexpr std::uint32_t kJson = 0x4E4F534A, kBinary = 0x004E4942;
  std::string_view text = bytes;
  if (bytes.starts_with("glTF")) {
    if (bytes.size() < 12) gltf_fail("GLB", "a header of 12 bytes");
    BinaryCursor header(bytes, 4, ByteOrder::Little);
    const auto version = header.take<std::uint32_t>();
    if (version != 2) {
      gltf_fail("GLB", "version 2, found " + std::to_string(version), ErrorCode::Unreadable);
    }
    const std::size_t length = header.take<std::uint32_t>();
    const std::string_view all = slice(bytes, 0, length, "GLB");
    trailing_ = bytes.size() - length;
    std::size_t offset = 12;
    bool has_text = false;
    while (offset < length) {
      const std::string where = "GLB, at byte " + std::to_string(offset);
      BinaryCursor chunk(slice(all, offset, 8, where), 0, ByteOrder::Little);
      const std::size_t size = chunk.take<std::uint32_t>();
      const auto type = chunk.take<std::uint32_t>();
      const std::string_view content = slice(all, offset + 8, size, where);
      if (!has_text && type != kJson) gltf_fail(where, "a chunk of JSON first");
      if (!has_text) text = content;
      if (has_text && type == kBinary && !binary_chunk_) binary_chunk_ = content;
      has_text = true;
      offset += 8 + size;
    }
    if (!has_text) gltf_fail("GLB", "a chunk of JSON");
  }
  JsonDocument reader({"matrix", "rotation", "scale", "translation"});
  parse_json_events(text, reader);
  root_ = std::move(reader.document);
}

void GltfDocument::require_known_extensions() const {
  for (const json& name : list("extensionsRequired")) {
    const std::string extension = name.is_string() ? name.get<std::string>() : dump_json(name);
    if (is_harmless(extension)) continue;
    const bool is_compressed = extension == "KHR_draco_mesh_compression" ||
                               extension.find("meshopt_compression") != extension.npos;
    throw Error(ErrorCode::Unreadable,
                "the file needs a reader that knows " + extension + ", which this one does not" +
                    (is_compressed ? "; export it without compression" : ""));
  }
}

const json& GltfDocument::list(const char* name) const {
  static const json kNone = json::array();
  const auto found = root_.find(name);
  if (found == root_.end()) return kNone;
  if (!found->is_array()) gltf_fail(name, "an array");
  return *found;
}

std::size_t GltfDocument::index(const json& value, const char* name,
                                const std::string& where) const {
  const json& items = list(name);
  if (items.empty())
    gltf_fail(where, std::string("an index into ") + name + ", which has no items");
  const auto found = static_cast<std::size_t>(gltf_unsigned(value, items.size(), where));
  if (!items[found].is_object()) gltf_fail(gltf_place(name, found), "an object");
  return found;
}

std::string_view GltfDocument::buffer(std::size_t index) {
  const std::string where = gltf_place("buffers", index);
  const json& item = list("buffers")[index];
  const std::uint64_t size =
      gltf_unsigned(required(item, "byteLength", where), kAnyUnsigned, where + ".byteLength");
  const auto uri = item.find("uri");
  if (uri == item.end()) {
    if (index != 0 || !binary_chunk_) gltf_fail(where, "a uri, or the bytes of a .glb");
    return slice(*binary_chunk_, 0, size, where);
  }
  if (!uri->is_string()) gltf_fail(where + ".uri", "text");
  auto found = loaded_.find(index);
  if (found == loaded_.end()) {
    const std::string text = uri->get<std::string>();
    constexpr std::string_view kEncoded = ";base64,";
    std::string bytes;
    if (text.starts_with("data:")) {
      const std::size_t start = text.find(kEncoded);
      if (start == text.npos) gltf_fail(where + ".uri", "data:...;base64,...");
      bytes = from_base64(std::string_view(text).substr(start + kEncoded.size()));
    } else {
      bytes = read_bytes(file_beside(folder_, text));
    }
    total_bytes_ += bytes.size();
    found = loaded_.emplace(index, std::move(bytes)).first;
  }
  return slice(found->second, 0, size, where);
}

std::string_view GltfDocument::view(const json& value, const std::string& where_from,
                                    std::uint64_t* stride) {
  const std::size_t number = index(value, "bufferViews", where_from + ".bufferView");
  const std::string where = gltf_place("bufferViews", number);
  const json& item = list("bufferViews")[number];
  if (item.contains("extensions") && item["extensions"].is_object()) {
    for (const auto& [name, content] : item["extensions"].items()) {
      if (name.find("meshopt_compression") == name.npos) continue;
      throw Error(ErrorCode::Unreadable,
                  where + " is compressed by " + name + "; export it without compression");
    }
  }
  const std::size_t of = index(required(item, "buffer", where), "buffers", where + ".buffer");
  const std::uint64_t size =
      gltf_unsigned(required(item, "byteLength", where), kAnyUnsigned, where + ".byteLength");
  if (stride) *stride = unsigned_or(item, "byteStride", 0, where);
  return slice(buffer(of), unsigned_or(item, "byteOffset", 0, where), size, where);
}

GltfAccessor GltfDocument::accessor(std::size_t number) {
  GltfAccessor accessor;
  accessor.where = gltf_place("accessors", number);
  const std::string& where = accessor.where;
  const json& item = list("accessors")[number];
  constexpr std::array<std::pair<std::string_view, std::size_t>, 3> kTypes = {
      {{"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}}};
  const json& type = required(item, "type", where);
  const auto known = std::find_if(kTypes.begin(), kTypes.end(), [&](const auto& entry) {
    return type.is_string() && type.get_ref<const std::string&>() == entry.first;
  });
  if (known == kTypes.end()) gltf_fail(where + ".type", "SCALAR, VEC2 or VEC3");
  accessor.components = known->second;
  accessor.type = static_cast<unsigned>(
      gltf_unsigned(required(item, "componentType", where), 65536, where + ".componentType"));
  const std::uint64_t count =
      gltf_unsigned(required(item, "count", where), kAnyUnsigned, where + ".count");
  accessor.is_normalized = item.contains("normalized") && item["normalized"] == true;
  const std::size_t element = accessor.components * accessor.component_size();
  accessor.stride_ = element;
  if (item.contains("bufferView") && count > 0) {
    std::uint64_t stride = 0;
    const std::string_view bytes = view(item["bufferView"], where, &stride);
    if (stride == 0) stride = element;
    if (stride < element || stride > 65536) {
      gltf_fail(where, "a byteStride from " + std::to_string(element) + " to 65536, found " +
                           std::to_string(stride));
    }
    accessor.stride_ = static_cast<std::size_t>(stride);
    if (count - 1 > bytes.size() / accessor.stride_) {
      gltf_fail(where, std::to_string(count) + " elements of " + std::to_string(accessor.stride_) +
                           " bytes each, found " + counted(bytes.size(), "byte", "bytes"));
    }
    const std::uint64_t size = (count - 1) * stride + element;
    accessor.bytes_ = slice(bytes, unsigned_or(item, "byteOffset", 0, where), size, where);
  } else if (count > total_bytes_) {
    gltf_fail(where,
              "at most as many elements as the file has bytes");  // all zero, so no bytes hold it
  }
  accessor.count = static_cast<std::size_t>(count);
  if (item.contains("sparse")) read_sparse(item["sparse"], accessor);
  return accessor;
}

// Elements that differ from those of the buffer. (Section 3.6.2.3.)
void GltfDocument::read_sparse(const json& sparse, GltfAccessor& accessor) {
  const std::string where = accessor.where + ".sparse";
  if (!sparse.is_object()) gltf_fail(where, "an object");
  const std::uint64_t count = gltf_unsigned(required(sparse, "count", where),
                                            std::uint64_t{accessor.count} + 1, where + ".count");
  const json& indices = required(sparse, "indices", where);
  const json& values = required(sparse, "values", where);
  if (!indices.is_object() || !values.is_object())
    gltf_fail(where, "indices and values as objects");
  GltfAccessor index;
  index.where = where + ".indices";
  index.type = static_cast<unsigned>(
      gltf_unsigned(required(indices, "componentType", index.where), 65536, index.where));
  if (index.type != kUnsignedByte && index.type != kUnsignedShort && index.type != kUnsignedInt) {
    gltf_fail(index.where + ".componentType", "5121, 5123 or 5125");
  }
  index.stride_ = index.component_size();
  const std::size_t element = accessor.components * accessor.component_size();
  const auto bytes_of = [&](const json& part, const std::string& name, std::uint64_t size) {
    const std::string_view bytes = view(required(part, "bufferView", name), name, nullptr);
    if (count > bytes.size()) gltf_fail(name, std::to_string(count) + " elements");
    return slice(bytes, unsigned_or(part, "byteOffset", 0, name), count * size, name);
  };
  index.bytes_ = bytes_of(indices, index.where, index.stride_);
  const std::string_view replacing = bytes_of(values, where + ".values", element);
  for (std::size_t k = 0; k < count; ++k) {
    const auto target = static_cast<std::size_t>(index.stored(k, 0));
    if (target >= accessor.count) {
      gltf_fail(index.where, "indices below " + std::to_string(accessor.count) + ", found " +
                                 std::to_string(target));
    }
    accessor.replaced_[target] = replacing.substr(k * element, element);
  }
}

}  // namespace convexact
