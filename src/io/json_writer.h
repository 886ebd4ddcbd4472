#ifndef STEREO_SGMP_IO_JSON_WRITER_H_
#define STEREO_SGMP_IO_JSON_WRITER_H_

#include <string>
#include <vector>

namespace stereo_sgmp {

// Builds one JSON object of numbers, strings, switches, lists and nested objects, in the order of
// the calls. Numbers that JSON can't hold (infinite, NaN) become null.
class JsonWriter {
 public:
  void Value(const std::string& key, double value);
  void Value(const std::string& key, int value) { Value(key, static_cast<double>(value)); }
  void Value(const std::string& key, bool value);
  void Value(const std::string& key, const std::string& value);
  void Value(const std::string& key, const char* value) { Value(key, std::string(value)); }

  // Values from here to the matching EndObject belong to the object `key`.
  void BeginObject(const std::string& key);
  void EndObject();

  // A list on one line.
  void Array(const std::string& key, const std::vector<double>& values);
  void Array(const std::string& key, const std::vector<std::string>& values);

  // Objects from here to the matching EndArray are elements of the list `key`; they are begun
  // without a key and ended by EndObject.
  void BeginArray(const std::string& key);
  void BeginObject();
  void EndArray();

  // The text so far with the outermost object closed.
  std::string Text() const { return text_ + "\n}\n"; }

 private:
  void NextLine();
  void Key(const std::string& key);
  void Open(char bracket);
  void Close(char bracket);

  std::string text_ = "{";
  std::string indent_ = "  ";
  bool first_ = true;
};

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_IO_JSON_WRITER_H_
