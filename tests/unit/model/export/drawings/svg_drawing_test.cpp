#include "model/export/drawings/svg_drawing.h"

#include <QXmlStreamReader>
#include <QtTest>
#include <sstream>

#include "tests/unit/model/export/drawings/drawn_board.h"

namespace {

struct Layer {
    QString id, title, fill, rule, stroke;
    std::vector<std::string> paths;
    std::vector<std::string> filled;  ///< of them, those that say it of themselves
};

struct Svg {
    QString width, height, viewBox, title;
    std::vector<Layer> layers;

    explicit Svg(const std::string& text) {
        QXmlStreamReader xml(QByteArray::fromStdString(text));
        while (!xml.atEnd()) {
            if (xml.readNext() == QXmlStreamReader::StartElement) {
                take(xml);
            }
        }
        if (xml.hasError()) {
            qFatal("%s", qPrintable(xml.errorString()));
        }
    }

    std::vector<QStringList> names;  ///< text, x, y, size, colour and turn

private:
    void take(QXmlStreamReader& xml) {
        const auto value = [&](const char* name) { return xml.attributes().value(QLatin1String(name)).toString(); };
        if (xml.name() == QLatin1String("svg")) {
            width = value("width");
            height = value("height");
            viewBox = value("viewBox");
        } else if (xml.name() == QLatin1String("g")) {
            layers.push_back({value("id"), {}, value("fill"), value("fill-rule"), value("stroke"), {}, {}});
        } else if (xml.name() == QLatin1String("path")) {
            layers.back().paths.push_back(value("d").toStdString());
            if (value("stroke") == "none" && value("fill").startsWith('#') && value("fill-rule") == "evenodd") {
                layers.back().filled.push_back(layers.back().paths.back());
            }
        } else if (xml.name() == QLatin1String("text")) {
            names.push_back(
                {value("x"), value("y"), value("font-size"), value("fill"), value("stroke"), value("transform")});
            names.back().prepend(xml.readElementText());
        } else if (xml.name() == QLatin1String("title")) {
            (layers.empty() ? title : layers.back().title) = xml.readElementText();
        }
    }
};

/// The area of a path of M, L, A and Z, and whether all arcs are on circles through their ends.
double areaOf(const std::string& path) {
    std::istringstream in(path);
    double area = 0.0, x = 0.0, y = 0.0, startX = 0.0, startY = 0.0;
    char command = 0;
    while (in >> command) {
        double nextX = startX, nextY = startY, radius = 0.0, skipped = 0.0;
        int isLong = 0, isPositive = 0;
        if (command == 'A') {
            in >> radius >> skipped >> skipped >> isLong >> isPositive;
        }
        if (command != 'Z') {
            in >> nextX >> nextY;
        }
        if (command == 'M') {
            startX = nextX;
            startY = nextY;
        } else {
            area += drawn_board::underChord(x, y, nextX, nextY);
        }
        if (command == 'A') {
            const double chord = std::hypot(nextX - x, nextY - y);
            const double sweep = 2 * std::asin(std::min(1.0, chord / 2 / radius));
            area += drawn_board::besideChord(chord, isPositive != 0 ? sweep : -sweep);
        }
        x = nextX;
        y = nextY;
    }
    return area;
}

Svg svgOf(const model::Document& board, const model::DrawingOptions& options) {
    return Svg(drawn_board::written(
        [&](model::FileWriter& file, base::Progress& progress) { return writeSvg(board, options, file, progress); }));
}

double areaOf(const Layer& layer) {
    double area = 0.0;
    for (const std::string& path : layer.paths) {
        area += areaOf(path);
    }
    return area;
}

}  // namespace

class SvgDrawingTest : public QObject {
    Q_OBJECT

private slots:
    void thePictureIsAsLargeAsTheBoard() {
        const Svg svg = svgOf(*drawn_board::board(), {});
        QCOMPARE(svg.width, QString("62mm"));  // with its margin
        QCOMPARE(svg.height, QString("42mm"));
        QCOMPARE(svg.viewBox, QString("0 0 62 42"));
        QCOMPARE(svg.title, QString("job & co"));
    }

    void bodiesHaveTheirDesignators() {
        model::DrawingOptions options;
        options.colours = {0xFF0000};
        const Svg svg = svgOf(*drawn_board::boardOfBodies(), options);
        QCOMPARE(svg.names.size(), std::size_t{2});
        QCOMPARE(svg.names[0], QStringList({"R1", "3", "8.504", "1.4", "#ff0000", "none", ""}));
        QCOMPARE(svg.names[1], QStringList({"U<10>", "11.5", "5.252", "0.7", "#ff0000", "none", "rotate(-90 11.5 5)"}));
    }

    void layersAreGroupsTheLowestFirst() {
        model::DrawingOptions options;
        options.colours = {0xFF0000, 0x0000FF, 0x123456};
        options.outlineColour = 0x00FF00;
        const Svg svg = svgOf(*drawn_board::board(), options);
        const std::vector<std::array<QString, 4>> expected{{"layer-2", "bottom", "#0000ff", ""},
                                                           {"layer-1", "top <1>", "#ff0000", ""},
                                                           {"layer-3", "drill", "#123456", ""},
                                                           {"layer-outline", "board outline", "none", "#00ff00"}};
        QCOMPARE(svg.layers.size(), expected.size());
        for (std::size_t i = 0; i < expected.size(); ++i) {
            const Layer& layer = svg.layers[i];
            QCOMPARE((std::array<QString, 4>{layer.id, layer.title, layer.fill, layer.stroke}), expected[i]);
            QCOMPARE(layer.rule, QString(i < 3 ? "evenodd" : ""));
        }
    }

    /// y runs down, so what winds counter-clockwise on the board has a negative area here.
    void pathsCoverWhatTheElementsDo() {
        const Svg svg = svgOf(*drawn_board::board(), {});
        QVERIFY(std::abs(areaOf(svg.layers[0]) + drawn_board::kBottom) < 1e-5);
        QVERIFY(std::abs(areaOf(svg.layers[1]) + drawn_board::kTop) < 1e-5);
        QVERIFY(svg.layers[1].paths[0].starts_with("M5 37A1 1 0 0 0 "));  // the disc at (3, 4), from its right end
    }

    /// A line along the edge of what a pen drew would make it wider than it is.
    void onLayersOfOutlinesOnlyAreasAreContours() {
        const Svg svg = svgOf(*drawn_board::boardOfOutlines(), {});
        const Layer& layer = svg.layers[0];
        QCOMPARE(layer.fill, QString("none"));
        QCOMPARE(layer.paths.size(), std::size_t{3});
        QCOMPARE(layer.filled.size(), std::size_t{2});
        QVERIFY(std::abs(areaOf(layer.filled[0]) + drawn_board::kTrack) < 1e-5);
        QVERIFY(std::abs(areaOf(layer.filled[1]) + drawn_board::kDisc) < 1e-5);
    }

    void copiesAreDrawn() {
        const Svg svg = svgOf(*drawn_board::panel(), {});
        QCOMPARE(svg.viewBox, QString("0 0 222 42"));  // from -60 to 160 mm
        QVERIFY(std::abs(areaOf(svg.layers[0]) + drawn_board::kBottom + drawn_board::kTop) < 1e-5);
    }

    void failuresLeaveNothing() { drawn_board::checkFailures(model::writeSvg); }
};

QTEST_GUILESS_MAIN(SvgDrawingTest)
#include "svg_drawing_test.moc"
