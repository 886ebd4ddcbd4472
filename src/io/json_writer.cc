#include "io/json_writer.h"

#include <cmath>
#include <cstddef>
#include <locale>
#include <sstream>

namespace stereo_sgmp {
namespace {

constexpr std::size_t kIndent = 2;

std::string Quoted(const std::string& text) {
  constexpr char kHex[] = "0123456789abcdef";
  std::string quoted = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x20) {
      quoted += std::string("\\u00") + kHex[code >> 4] + kHex[code & 15];
    } else {
      if (c == '"' || c == '\\') quoted += '\\';
      quoted += c;
    }
  }
  return quoted + '"';
}

}  // namespace

void JsonWriter::Value(const std::string& key, double value) {
  constexpr int kDigits = 9;
  Key(key);
  std::ostringstream number;
  number.imbue(std::locale::classic());
  number.precision(kDigits);
  number << value;
  text_ += std::isfinite(value) ? number.str() : "null";
}

void JsonWriter::Value(const std::string& key, bool value) {
  Key(key);
  text_ += value ? "true" : "false";
}

void JsonWriter::Value(const std::string& key, const std::string& value) {
  Key(key);
  text_ += Quoted(value);
}

void JsonWriter::BeginObject(const std::string& key) {
  Key(key);
  text_ += "{";
  indent_.append(kIndent, ' ');
  first_ = true;
}

void JsonWriter::EndObject() {
  indent_.resize(indent_.size() - kIndent);
  text_ += "\n" + indent_ + "}";
  first_ = false;
}

void JsonWriter::Key(const std::string& key) {
  text_ += (first_ ? "\n" : ",\n") + indent_ + Quoted(key) + ": ";
  first_ = false;
}

}  // namespace stereo_sgmp
