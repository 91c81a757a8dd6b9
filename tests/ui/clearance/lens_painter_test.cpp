// Lines and numbers of the clearance lens, and what they are seen against.
#include "ui/clearance/lens_painter.h"

#include <QRandomGenerator>
#include <QtTest>

#include "model/board/board_colours.h"
#include "model/board/document_builder.h"
#include "render/scene/layer_style.h"
#include "tests/colour_vision.h"
#include "ui/views/nearby_highlight.h"

using model::LayerSide;
using model::LayerType;
using ui::LensPainter;
using Lines = std::vector<LensPainter::Line>;

namespace {

constexpr QSize kCanvas(800, 600);

struct Painted {
    QImage image{kCanvas, QImage::Format_ARGB32_Premultiplied};
    std::vector<LensPainter::Number> numbers;

    explicit Painted(const Lines& lines, QColor ground = Qt::transparent) {
        image.fill(ground);
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        numbers = LensPainter(painter, QRectF(QPointF(), kCanvas)).paint(lines, ui::LengthUnit::Millimetre);
    }
};

/// The nearest first, as the lens has them.
Lines randomLines(int count, double longest) {
    QRandomGenerator random(11);
    Lines lines;
    for (int i = 0; i < count; ++i) {
        const QPointF from(random.bounded(1000.0) - 100.0, random.bounded(800.0) - 100.0);
        lines.push_back({from, from + QPointF(random.bounded(longest), random.bounded(longest)), 1e4 + 1e3 * i});
    }
    return lines;
}

glm::vec3 rgb(const QColor& colour) {
    return {colour.redF(), colour.greenF(), colour.blueF()};
}

/// Every colour that a layer has by itself, of both palettes, in drawings and on boards of all colours.
std::vector<glm::vec3> layerColours() {
    model::DocumentBuilder builder;
    const auto add = [&](LayerType type, LayerSide side, bool isSynthetic) {
        model::Layer layer;
        layer.type = type;
        layer.side = side;
        layer.isSynthetic = isSynthetic;
        builder.addLayer(layer);
    };
    for (int type = 0; type <= static_cast<int>(LayerType::Other); ++type) {
        for (const LayerSide side : {LayerSide::Top, LayerSide::Inner, LayerSide::Bottom}) {
            add(static_cast<LayerType>(type), side, false);
            add(static_cast<LayerType>(type), side, true);
        }
    }
    for (int inner = 0; inner < 38; ++inner) {
        add(LayerType::Signal, LayerSide::Inner, false);
    }
    const auto board = builder.finish();
    std::vector<glm::vec3> colours;
    for (const std::string& name : model::boardColourNames()) {
        const auto chosen = model::boardColourNamed(name);
        for (const std::string& finish : model::surfaceFinishNames()) {
            const auto dressed = model::boardColours(*board, {chosen, chosen, model::surfaceFinishNamed(finish)});
            for (const auto palette : {render::Palette::Standard, render::Palette::ColourBlindSafe}) {
                for (const auto appearance : {render::Appearance::Flat, render::Appearance::Solid}) {
                    for (const auto& style : render::defaultStyles(*board, appearance, palette, dressed)) {
                        colours.push_back(style.colour);
                    }
                }
            }
        }
    }
    return colours;
}

/// How far the better one of a colour and its edge is from the layer that is nearest to it.
double leastContrast(const glm::vec3& colour, const glm::vec3& edge, const vision::Vision& sight) {
    double least = 1e9;
    for (const glm::vec3& layer : layerColours()) {
        least = std::min(least, std::max(vision::distance(colour, layer, sight), vision::distance(edge, layer, sight)));
    }
    return least;
}

}  // namespace

class LensPainterTest : public QObject {
    Q_OBJECT

private slots:
    void everyLineWithRoomHasItsNumber() {
        const Painted painted(Lines{{{100, 100}, {140, 100}, 0.1e6}, {{400, 300}, {400, 380}, 0.2e6}});
        QCOMPARE(painted.numbers.size(), std::size_t{2});
        QVERIFY(painted.numbers[0].box.intersects(QRectF(80, 60, 120, 80)));
        QVERIFY(painted.numbers[1].box.intersects(QRectF(340, 280, 140, 120)));
        QVERIFY(painted.image.pixelColor(120, 100) == LensPainter::kLine);
        QVERIFY(qAlpha(painted.image.pixel(painted.numbers[0].box.center().toPoint())) > 200);
    }

    void numbersAreThoseOfTheNearestAndNoneLiesOnAnother() {
        const Painted painted(randomLines(3000, 60.0));
        const auto& numbers = painted.numbers;
        QVERIFY2(numbers.size() > 10 && numbers.size() <= LensPainter::kMostNumbers,
                 qPrintable(QString::number(numbers.size())));
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            QVERIFY(numbers[i].line < 2 * LensPainter::kMostNumbers);  // some are beside the canvas
            QVERIFY(QRectF(QPointF(), kCanvas).contains(numbers[i].box));
            for (std::size_t k = 0; k < i; ++k) {
                QVERIFY(numbers[k].line < numbers[i].line);
                QVERIFY(!numbers[k].box.intersects(numbers[i].box));
            }
        }
    }

    void linesWithoutRoomForTheirNumberAreDrawnAllTheSame() {
        Lines lines;
        for (int i = 0; i < 60; ++i) {
            lines.push_back({{400.0 + i, 280}, {400.0 + i, 320}, 1e5 + i});
        }
        const Painted painted(lines);
        QVERIFY(painted.numbers.size() < 12);
        for (int x = 402; x < 458; ++x) {
            QVERIFY(qAlpha(painted.image.pixel(x, 300)) > 0);
        }
    }

    void dotsHaveNoNumber() {
        const Painted painted(Lines{{{100, 100}, {101, 101}, 1e4}, {{400, 300}, {440, 300}, 2e5}});
        QCOMPARE(painted.numbers.size(), std::size_t{1});
        QCOMPARE(painted.numbers.front().line, std::size_t{1});
        QVERIFY(qAlpha(painted.image.pixel(100, 100)) == 255);
    }

    void whatIsBesideTheCanvasIsLeftOutAndWhatCrossesItIsNot() {
        QVERIFY(Painted({{{-50, 10}, {-10, 10}, 1e5}}).numbers.empty());
        QCOMPARE(Painted({{{-50, 300}, {900, 300}, 1e6}}).numbers.size(), std::size_t{1});
    }

    /// Just seen is 2 to 3; the colour or its edge is many times that away from every layer.
    void linesAndNearObjectsStandOutFromEveryLayer() {
        constexpr double kLeast = 40.0;
        constexpr glm::vec3 kSilhouette(0.019F);  // shaders/lib/surface.glsl
        const glm::vec3 highlight = render::kHighlightColours[ui::nearbyHighlight(1)];
        for (const vision::Vision& sight : vision::kVisions) {
            const double line = leastContrast(rgb(LensPainter::kLine), rgb(LensPainter::kEdge), sight);
            const double outline = leastContrast(rgb(ui::kNearbyOutline), glm::vec3(0.0F), sight);
            const double object = leastContrast(highlight, kSilhouette, sight);
            qInfo("%s: lines %.0f, outlines %.0f, objects %.0f", sight.name, line, outline, object);
            QVERIFY2(std::min({line, outline, object}) > kLeast, sight.name);
            QVERIFY(vision::distance(rgb(LensPainter::kLine), rgb(LensPainter::kEdge), sight) > 80.0);
        }
    }

    void theSelectedObjectDiffersFromItsNeighboursForEveryEye() {
        for (const vision::Vision& sight : vision::kVisions) {
            const double outlines = vision::distance(rgb(ui::kSelectedOutline), rgb(ui::kNearbyOutline), sight);
            qInfo("%s: outlines %.0f", sight.name, outlines);
            QVERIFY2(outlines > 20.0, sight.name);
            for (std::size_t nets = 0; nets < 3; ++nets) {
                const glm::vec3 near = render::kHighlightColours[ui::nearbyHighlight(nets)];
                const glm::vec3 selected = render::kHighlightColours.front();
                QVERIFY2(vision::distance(selected, near, sight) > 30.0, sight.name);
            }
        }
    }

    void nearObjectsHaveAColourOfTheirOwnBesideHighlightedNets() {
        for (std::size_t nets = 0; nets < render::kHighlightColours.size(); ++nets) {
            QVERIFY(nets == 0 || ui::nearbyHighlight(nets) >= nets || nets > render::kHighlightColours.size());
            QVERIFY(ui::nearbyHighlight(nets) < render::kHighlightColours.size());
        }
    }
};

QTEST_MAIN(LensPainterTest)
#include "lens_painter_test.moc"
