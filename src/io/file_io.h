// Files in and out, whole where not said otherwise.
#ifndef STEREO_SGMP_IO_FILE_IO_H_
#define STEREO_SGMP_IO_FILE_IO_H_

#include <fstream>
#include <functional>
#include <string>

namespace stereo_sgmp {

// A file to read piece by piece, in binary. Throws std::invalid_argument for one that is missing, a
// folder or can't be opened.
std::ifstream OpenFile(const std::string& path);

// The bytes of a file. Throws as OpenFile, and for one that is empty or can't be read to its end.
std::string ReadFile(const std::string& path);

// Calls write(temporary) with the path of a file beside `path` and of the same extension, then
// renames it to `path`: a reader sees the old file or the whole new one. Whatever `write` throws
// passes through, with the temporary removed and `path` untouched. Where `path` is no regular
// file (/dev/stdout, a pipe) it is written in place.
void WriteAtomically(const std::string& path, const std::function<void(const std::string&)>& write);

// The same for bytes. Throws std::runtime_error when they can't be written.
void WriteFile(const std::string& path, const std::string& bytes);

// Throws std::invalid_argument when the folder that `path` would stand in does not exist or
// `path` is a folder itself: found before long work rather than after it.
void CheckWritable(const std::string& path);

}  // namespace stereo_sgmp

#endif  // STEREO_SGMP_IO_FILE_IO_H_
