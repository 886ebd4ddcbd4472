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

std::string NumberText(const double& value) {
  constexpr int kDigits = 9;
  if (!std::isfinite(value)) return "null";
  std::ostringstream number;
  number.imbue(std::locale::classic());
  number.precision(kDigits);
  number << value;
  return number.str();
}

template <class T>
std::string ListText(const std::vector<T>& values, std::string (*text_of)(const T&)) {
  std::string list = "[";
  for (const T& value : values) list += (list.size() > 1 ? ", " : "") + text_of(value);
  return list + ']';
}

}  // namespace

void JsonWriter::Value(const std::string& key, double value) {
  Key(key);
  text_ += NumberText(value);
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
  Open('{');
}

void JsonWriter::EndObject() { Close('}'); }

void JsonWriter::Array(const std::string& key, const std::vector<double>& values) {
  Key(key);
  text_ += ListText(values, NumberText);
}

void JsonWriter::Array(const std::string& key, const std::vector<std::string>& values) {
  Key(key);
  text_ += ListText(values, Quoted);
}

void JsonWriter::BeginArray(const std::string& key) {
  Key(key);
  Open('[');
}

void JsonWriter::BeginObject() {
  NextLine();
  Open('{');
}

void JsonWriter::EndArray() { Close(']'); }

void JsonWriter::NextLine() {
  text_ += (first_ ? "\n" : ",\n") + indent_;
  first_ = false;
}

void JsonWriter::Key(const std::string& key) {
  NextLine();
  text_ += Quoted(key) + ": ";
}

void JsonWriter::Open(char bracket) {
  text_ += bracket;
  indent_.append(kIndent, ' ');
  first_ = true;
}

void JsonWriter::Close(char bracket) {
  indent_.resize(indent_.size() - kIndent);
  text_ += "\n" + indent_ + bracket;
  first_ = false;
}

}  // namespace stereo_sgmp
