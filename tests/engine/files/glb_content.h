#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace glissade::test {

/// Parses a GLB file by the glTF 2.0 specification, with its own code.
class GlbContent {
 public:
  using Json = nlohmann::json;

  explicit GlbContent(const std::string& bytes) : bytes_(bytes) {
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(word(4), 2U);
    EXPECT_EQ(word(8), bytes.size());
    const std::size_t jsonBytes = word(12);
    EXPECT_EQ(bytes.substr(16, 4), "JSON");
    EXPECT_EQ(jsonBytes % 4, 0U);
    json = Json::parse(bytes.substr(20, jsonBytes));
    const std::size_t binary = 20 + jsonBytes;
    EXPECT_EQ(bytes.substr(binary + 4, 4), std::string("BIN\0", 4));
    EXPECT_EQ(word(binary) % 4, 0U);
    EXPECT_EQ(binary + 8 + word(binary), bytes.size());
    EXPECT_EQ(json["buffers"].size(), 1U);
    EXPECT_EQ(json["buffers"][0]["byteLength"], word(binary));
    buffer_ = binary + 8;
  }

  /// The elements of an accessor, as lists of numbers.
  std::vector<std::vector<float>> elements(std::size_t accessor) const {
    const Json& a = json["accessors"][accessor];
    const Json& view = json["bufferViews"][a["bufferView"].get<std::size_t>()];
    EXPECT_EQ(a["componentType"], 5126);
    const std::size_t columns = a["type"] == "SCALAR" ? 1 : a["type"] == "VEC3" ? 3 : 4;
    std::vector<std::vector<float>> all(a["count"].get<std::size_t>(), std::vector<float>(columns));
    EXPECT_EQ(view["byteLength"].get<std::size_t>(), all.size() * columns * sizeof(float));
    std::size_t at = buffer_ + view["byteOffset"].get<std::size_t>();
    for (std::vector<float>& element : all) {
      std::memcpy(element.data(), bytes_.data() + at, columns * sizeof(float));
      at += columns * sizeof(float);
    }
    return all;
  }

  Json json;

 private:
  std::uint32_t word(std::size_t at) const {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes_.data() + at, sizeof value);
    return value;
  }

  std::string bytes_;
  std::size_t buffer_ = 0;
};

}  // namespace glissade::test
