#include "render/frame/image_difference.h"

namespace render {

namespace {

/// Rec. 601 luma of a pixel, 0 to 1.
double grey(const Image& image, std::size_t pixel) {
    const std::uint8_t* rgba = &image.rgba[4 * pixel];
    return (0.299 * rgba[0] + 0.587 * rgba[1] + 0.114 * rgba[2]) / 255.0;
}

}  // namespace

double greyMse(const Image& a, const Image& b) {
    if (a.width != b.width || a.height != b.height || a.rgba.empty()) {
        return 1.0;
    }
    const std::size_t pixels = std::size_t{a.width} * a.height;
    double sum = 0.0;
    for (std::size_t i = 0; i < pixels; ++i) {
        const double difference = grey(a, i) - grey(b, i);
        sum += difference * difference;
    }
    return sum / static_cast<double>(pixels);
}

}  // namespace render
