#include "render/frame/png.h"

#include <png.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>

namespace render {
namespace {

base::Error outputError(const std::string& path, const std::string& reason) {
    return {base::ErrorCode::OutputFailed, "Cannot write " + path + ": " + reason + "."};
}

png_image headOf(const Image& image) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = image.width;
    png.height = image.height;
    png.format = PNG_FORMAT_RGBA;
    // Boards are plain colours and edges: without filters a picture is packed in a quarter of the time, as small.
    png.flags = PNG_IMAGE_FLAG_FAST;
    return png;
}

/// Empty, or why it failed.
std::string encode(const Image& image, std::FILE* file) {
    png_image png = headOf(image);
    errno = 0;
    if (png_image_write_to_stdio(&png, file, 0, image.rgba.data(), 0, nullptr) != 0) {
        return {};
    }
    const std::string reason = errno != 0 ? std::strerror(errno) : png.message;
    png_image_free(&png);
    return reason;
}

/// Leaves no half picture behind; devices such as /dev/full are left alone.
void removePartial(const std::string& path) {
    std::error_code ignored;
    if (std::filesystem::is_regular_file(path, ignored)) {
        std::filesystem::remove(path, ignored);
    }
}

}  // namespace

base::Result<std::string> encodePng(const Image& image) {
    png_image png = headOf(image);
    png_alloc_size_t size = 0;
    std::string bytes;
    for (const bool isSized : {false, true}) {
        bytes.resize(size);
        if (png_image_write_to_memory(&png, isSized ? bytes.data() : nullptr, &size, 0, image.rgba.data(), 0,
                                      nullptr) == 0) {
            return base::Error{base::ErrorCode::OutputFailed, std::string("Cannot make a picture: ") + png.message};
        }
    }
    bytes.resize(size);
    return bytes;
}

base::Status writePng(const Image& image, const std::string& path) {
    ASSERT(image.rgba.size() == std::size_t{image.width} * image.height * 4);
    std::FILE* file = std::fopen(path.c_str(), "wb");
    if (file == nullptr) {
        return outputError(path, std::strerror(errno));
    }
    std::string reason = encode(image, file);
    errno = 0;
    if (std::fclose(file) != 0 && reason.empty()) {
        reason = std::strerror(errno);
    }
    if (!reason.empty()) {
        removePartial(path);
        return outputError(path, reason);
    }
    return base::Done{};
}

}  // namespace render
