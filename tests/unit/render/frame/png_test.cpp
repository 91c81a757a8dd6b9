#include "render/frame/png.h"

#include <png.h>

#include <QtTest>
#include <string_view>

#include "render/scene/view_settings.h"

using namespace render;

class PngTest : public QObject {
    Q_OBJECT

    static Image gradient() {
        Image image{31, 17, {}};
        for (std::uint32_t i = 0; i < 31 * 17; ++i) {
            const auto value = static_cast<std::uint8_t>(i % 256);
            image.rgba.insert(image.rgba.end(), {value, static_cast<std::uint8_t>(255 - value), 128, 255});
        }
        return image;
    }

    /// Does not compress: as large as a picture of its size can get.
    static Image noise() {
        Image image{300, 300, {}};
        std::uint32_t state = 1;
        for (std::size_t i = 0; i < 300 * 300 * 4; ++i) {
            state = state * 1664525U + 1013904223U;
            image.rgba.push_back(static_cast<std::uint8_t>(state >> 24U));
        }
        return image;
    }

private slots:
    void whatIsWrittenIsReadBack() {
        const Image image = gradient();
        const auto packed = encodePng(image);
        QVERIFY(packed);
        png_image png{};
        png.version = PNG_IMAGE_VERSION;
        QVERIFY(png_image_begin_read_from_memory(&png, packed->data(), packed->size()) != 0);
        png.format = PNG_FORMAT_RGBA;
        QCOMPARE(png.width, 31U);
        QCOMPARE(png.height, 17U);
        std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(png));
        QVERIFY(png_image_finish_read(&png, nullptr, bytes.data(), 0, nullptr) != 0);
        QVERIFY(bytes == image.rgba);
    }

    void whatDoesNotCompressIsWhole() {
        const auto packed = encodePng(noise());
        QVERIFY(packed);
        QVERIFY(packed->size() > 300 * 300 * 4);
        QVERIFY(packed->ends_with(std::string_view("IEND\xAE\x42\x60\x82")));
    }
};

QTEST_APPLESS_MAIN(PngTest)
#include "png_test.moc"
