#include "render/frame/png.h"

#include <png.h>

#include <QtEndian>
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

    /// Each row of what is packed begins with the number of its filter.
    void rowsHaveNoFilter() {
        const Image image = gradient();
        const auto packed = encodePng(image);
        QVERIFY(packed);
        const QByteArray png = QByteArray::fromStdString(*packed);
        constexpr qsizetype kSignature = 8;
        constexpr qsizetype kAround = 12;  // of a piece: its length, name and sum
        const std::size_t rowSize = 1 + image.width * 4;
        QByteArray rows(4, '\0');  // how long they are, as qUncompress wants it
        qToBigEndian(static_cast<std::uint32_t>(rowSize * image.height), rows.data());
        for (qsizetype at = kSignature; at < png.size();) {
            const auto length = static_cast<qsizetype>(qFromBigEndian<std::uint32_t>(png.data() + at));
            if (png.sliced(at + 4, 4) == "IDAT") {
                rows += png.sliced(at + 8, length);
            }
            at += length + kAround;
        }
        const QByteArray unpacked = qUncompress(rows);
        QCOMPARE(static_cast<std::size_t>(unpacked.size()), rowSize * image.height);
        for (std::size_t row = 0; row < image.height; ++row) {
            QCOMPARE(int{unpacked[static_cast<qsizetype>(row * rowSize)]}, 0);
        }
    }

    /// Rows without alpha, and pieces as they come.
    void piecesMakeThePicture() {
        const Image image = gradient();
        std::vector<std::uint8_t> line;
        const PngRows rows{image.width, image.height, false, [&](std::uint32_t row) {
                               line.clear();
                               for (std::size_t i = 0; i < image.width * 4; ++i) {
                                   if (i % 4 != 3) {
                                       line.push_back(image.rgba[row * image.width * 4 + i]);
                                   }
                               }
                               return line.data();
                           }};
        std::string packed;
        QVERIFY(packPng(rows, [&](std::string_view piece) {
            packed += piece;
            return true;
        }));
        png_image png{};
        png.version = PNG_IMAGE_VERSION;
        QVERIFY(png_image_begin_read_from_memory(&png, packed.data(), packed.size()) != 0);
        QCOMPARE(png.format, png_uint_32(PNG_FORMAT_RGB));
        png.format = PNG_FORMAT_RGBA;
        std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(png));
        QVERIFY(png_image_finish_read(&png, nullptr, bytes.data(), 0, nullptr) != 0);
        QVERIFY(bytes == image.rgba);
    }

    void packingEndsWhereItIsNoLongerWanted() {
        const Image image = noise();
        std::uint32_t asked = 0;
        const PngRows rows{image.width, image.height, true, [&](std::uint32_t row) {
                               ++asked;
                               return image.rgba.data() + row * image.width * 4;
                           }};
        int pieces = 0;
        const base::Status packed = packPng(rows, [&](std::string_view) { return ++pieces < 8; });
        QVERIFY(!packed && packed.error().code == base::ErrorCode::Cancelled);
        QCOMPARE(pieces, 8);
        QVERIFY(asked < 200);
        QVERIFY_EXCEPTION_THROWN(
            static_cast<void>(packPng(rows, [](std::string_view) -> bool { throw std::bad_alloc(); })), std::bad_alloc);
        const PngRows none{0, 0, true, rows.row};
        const base::Status empty = packPng(none, [](std::string_view) { return true; });
        QVERIFY(!empty && empty.error().code == base::ErrorCode::OutputFailed);
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
