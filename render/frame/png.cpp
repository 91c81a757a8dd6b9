#include "render/frame/png.h"

#include <png.h>

#include <cstddef>
#include <memory>

namespace render {
namespace {

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

}  // namespace

base::Result<std::string> encodePng(const Image& image) {
    ASSERT(image.rgba.size() == std::size_t{image.width} * image.height * 4);
    png_image png = headOf(image);
    // Room for the worst case, as asking for the size would pack the picture twice.
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
    const auto room = std::make_unique_for_overwrite<char[]>(size);
    if (png_image_write_to_memory(&png, room.get(), &size, 0, image.rgba.data(), 0, nullptr) == 0) {
        return base::Error{base::ErrorCode::OutputFailed, std::string("Cannot make a picture: ") + png.message};
    }
    return std::string(room.get(), size);
}

}  // namespace render
