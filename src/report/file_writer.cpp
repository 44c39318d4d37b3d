#include "report/file_writer.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <system_error>
#include <vector>

#include "scene/error.h"

namespace viewcover {
namespace {

constexpr std::string_view kTemporaryPrefix = ".part.";

/// std::to_chars without a format gives at most 24 characters for a double.
using DecimalBuffer = std::array<char, 32>;

std::string_view decimal(double number, DecimalBuffer& buffer) {
  const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), number);
  return {buffer.data(), static_cast<std::size_t>(result.ptr - buffer.data())};
}

}  // namespace

std::filesystem::path temporary_beside(const std::filesystem::path& file) {
  return file.parent_path() / (std::string(kTemporaryPrefix) + file.filename().string());
}

void remove_temporary_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> left;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().filename().string().starts_with(kTemporaryPrefix)) {
      left.push_back(entry.path());
    }
  }
  for (const std::filesystem::path& file : left) {
    std::error_code error;
    std::filesystem::remove(file, error);
    if (error) throw InputError(file.string(), "cannot be removed: " + error.message(), "");
  }
}

void rename_into_place(const std::filesystem::path& temporary, const std::filesystem::path& file) {
  std::error_code error;
  std::filesystem::rename(temporary, file, error);
  if (!error) return;
  std::error_code ignored;
  std::filesystem::remove(temporary, ignored);
  throw InputError(file.string(), "cannot be written: " + error.message(),
                   "give a folder that can be written to");
}

FileWriter::FileWriter(std::filesystem::path file)
    : file_(std::move(file)), temporary_(temporary_beside(file_)) {
  descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail("cannot be written");
  buffer_.reserve(kBufferSize + 4096);
}

FileWriter::~FileWriter() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

FileWriter& FileWriter::operator<<(double number) {
  DecimalBuffer buffer;
  return *this << decimal(number, buffer);
}

void FileWriter::flush() {
  std::string_view left = buffer_;
  while (!left.empty()) {
    const ::ssize_t written = ::write(descriptor_, left.data(), left.size());
    if (written < 0) {
      if (errno == EINTR) continue;
      fail("cannot be written");
    }
    left.remove_prefix(static_cast<std::size_t>(written));
  }
  buffer_.clear();
}

void FileWriter::commit() {
  flush();
  // Without fsync a full disk may show only after the file has got its name. Pipes and some
  // special files cannot be synchronized; they say EINVAL.
  if (::fsync(descriptor_) != 0 && errno != EINVAL) fail("cannot be written");
  const int closed = ::close(descriptor_);
  descriptor_ = -1;
  if (closed != 0) fail("cannot be written");
  rename_into_place(temporary_, file_);
  temporary_.clear();
}

void FileWriter::fail(std::string_view what) {
  const std::string reason = std::generic_category().message(errno);
  throw InputError(file_.string(), std::string(what) + ": " + reason,
                   "give a folder that can be written to and has room");
}

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char character : text) {
    if (character == '"') quoted += '"';
    quoted += character;
  }
  return quoted += '"';
}

std::string shortest_decimal(double number) {
  DecimalBuffer buffer;
  return std::string(decimal(number, buffer));
}

}  // namespace viewcover
