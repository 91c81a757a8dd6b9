#include "model/text/whole_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

namespace model {

namespace fs = std::filesystem;

namespace {

base::Error cannotWrite(const fs::path& path, const std::string& why) {
    return {base::ErrorCode::OutputFailed, path.string() + " cannot be written: " + why};
}

bool writeAll(int file, const std::string& text) {
    std::size_t done = 0;
    bool isGood = true;
    while (isGood && done < text.size()) {
        const ssize_t count = ::write(file, text.data() + done, text.size() - done);
        isGood = count > 0 || (count < 0 && errno == EINTR);
        done += count > 0 ? static_cast<std::size_t>(count) : 0;
    }
    return isGood;
}

/// Empty, or why it failed.
std::string writeTo(const fs::path& path, const std::string& text, bool isPlain) {
    const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (file < 0) {
        return std::strerror(errno);
    }
    bool isGood = writeAll(file, text) && (!isPlain || ::fsync(file) == 0);
    const std::string why = std::strerror(errno);
    isGood = ::close(file) == 0 && isGood;
    return isGood ? "" : why;
}

}  // namespace

base::Result<std::string> readWholeFile(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::string text(std::istreambuf_iterator<char>(file), {});
    if (!file.is_open() || file.bad()) {
        return base::Error{base::ErrorCode::BadInput, path.string() + " cannot be read"};
    }
    return text;
}

base::Status writeWholeFile(const fs::path& named, const std::string& text) {
    std::error_code error;
    const fs::path linked = fs::is_symlink(named, error) ? fs::weakly_canonical(named, error) : named;
    const fs::path path = error ? named : linked;
    const bool isPlain = !fs::exists(path, error) || fs::is_regular_file(path, error);
    const fs::path beside = isPlain ? fs::path(path.string() + ".part" + std::to_string(::getpid())) : path;
    const std::string why = writeTo(beside, text, isPlain);
    if (isPlain && !why.empty()) {
        ::unlink(beside.c_str());
    }
    if (isPlain && why.empty()) {
        fs::rename(beside, path, error);
        if (error) {
            ::unlink(beside.c_str());
            return cannotWrite(path, error.message());
        }
    }
    return why.empty() ? base::Status(base::Done{}) : base::Status(cannotWrite(path, why));
}

}  // namespace model
