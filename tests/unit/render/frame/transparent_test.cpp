#include "render/frame/transparent.h"

#include <QtTest>
#include <cmath>

namespace {

using Pixel = std::array<std::uint8_t, 4>;

double linear(double byte) {
    const double c = byte / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

std::uint8_t encoded(double value) {
    const double sRgb = value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(sRgb * 255.0));
}

/// A colour with some alpha over a grey background, as it is drawn.
Pixel over(const Pixel& colour, double background) {
    const double alpha = colour[3] / 255.0;
    Pixel out{0, 0, 0, 255};
    for (std::size_t i = 0; i < 3; ++i) {
        out[i] = encoded(linear(colour[i]) * alpha + background * (1 - alpha));
    }
    return out;
}

render::Image imageOf(const std::vector<Pixel>& pixels) {
    render::Image image{static_cast<std::uint32_t>(pixels.size()), 1, {}};
    for (const Pixel& pixel : pixels) {
        image.rgba.insert(image.rgba.end(), pixel.begin(), pixel.end());
    }
    return image;
}

}  // namespace

class TransparentTest : public QObject {
    Q_OBJECT

private slots:
    void colourAndAlphaComeBack() {
        const std::vector<Pixel> colours{
            {200, 100, 50, 255}, {0, 0, 0, 255}, {255, 255, 255, 255}, {200, 100, 50, 128}, {20, 200, 240, 60}};
        std::vector<Pixel> black;
        std::vector<Pixel> white;
        for (const Pixel& colour : colours) {
            black.push_back(over(colour, 0.0));
            white.push_back(over(colour, 1.0));
        }
        const render::Image image = render::withoutBackground(imageOf(black), imageOf(white));
        for (std::size_t i = 0; i < colours.size(); ++i) {
            for (std::size_t k = 0; k < 4; ++k) {
                const int tolerance = colours[i][3] == 255 ? 0 : 4;
                QVERIFY2(std::abs(image.rgba[4 * i + k] - colours[i][k]) <= tolerance,
                         qPrintable(QString("colour %1 channel %2: %3").arg(i).arg(k).arg(image.rgba[4 * i + k])));
            }
        }
    }

    void nothingIsClear() {
        const render::Image image =
            render::withoutBackground(imageOf({{0, 0, 0, 255}}), imageOf({{255, 255, 255, 255}}));
        QCOMPARE(image.rgba, (std::vector<std::uint8_t>{0, 0, 0, 0}));
    }
};

QTEST_APPLESS_MAIN(TransparentTest)
#include "transparent_test.moc"
