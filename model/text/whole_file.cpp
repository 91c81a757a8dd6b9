#include "model/text/whole_file.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <system_error>

#include "model/text/file_writer.h"

namespace model {

namespace {

std::string reasonFor(const std::filesystem::path& path) {
    std::error_code error;
    const std::filesystem::file_type type = std::filesystem::status(path, error).type();
    return type == std::filesystem::file_type::not_found   ? ": there is no such file"
           : type == std::filesystem::file_type::directory ? ": it is a folder"
                                                           : "";
}

}  // namespace

base::Result<std::string> readWholeFile(const std::filesystem::path& path, std::uint64_t most) {
    std::ifstream file(path, std::ios::binary);
    std::error_code error;
    const std::uintmax_t size = std::filesystem::file_size(path, error);  // not known of pipes and devices
    std::string text;
    text.reserve(error ? 0 : std::min<std::uintmax_t>(size, most));
    std::array<char, 1U << 16U> piece{};
    while (file && text.size() <= most) {
        file.read(piece.data(), piece.size());
        text.append(piece.data(), static_cast<std::size_t>(file.gcount()));
    }
    if (!file.is_open() || file.bad()) {
        return base::Error{base::ErrorCode::BadInput, path.string() + " cannot be read" + reasonFor(path)};
    }
    if (text.size() > most) {
        return base::Error{base::ErrorCode::BadInput,
                           path.string() + " holds " + base::moreThan(most, "bytes") + " for such a file"};
    }
    return text;
}

base::Status writeWholeFile(const std::filesystem::path& path, const std::string& text) {
    FileWriter writer(path);
    writer.write(text);
    return writer.commit();
}

}  // namespace model
