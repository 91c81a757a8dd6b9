#include "model/formats/ipc2581/layer_list.h"

#include <QtTest>

#include "model/geometry/outlines.h"
#include "tests/unit/model/formats/ipc2581/ipc_files.h"

using namespace ipc_files;
using model::Box;
using model::Nm;
using model::ShapeSketch;

class LayerListTest : public QObject {
    Q_OBJECT

private slots:
    void outlinesOfALayerAreUnited_data() {
        QTest::addColumn<int>("x");
        QTest::addColumn<std::size_t>("contours");
        QTest::newRow("apart") << 20 << std::size_t{2};
        QTest::newRow("overlapping") << 5 << std::size_t{1};
    }
    void outlinesOfALayerAreUnited() {
        QFETCH(int, x);
        QFETCH(std::size_t, contours);
        const auto profile = [](int from) {
            const std::string left = std::to_string(from);
            const std::string right = std::to_string(from + 10);
            return "<Profile><Polygon><PolyBegin x='" + left + "' y='0'/><PolyStepSegment x='" + right +
                   "' y='0'/><PolyStepSegment x='" + right + "' y='10'/><PolyStepSegment x='" + left +
                   "' y='10'/></Polygon></Profile>";
        };
        const auto job = parse(fileWith(
            {}, {}, "<Layer name='X' layerFunction='PLANE' side='INTERNAL'>" + profile(0) + profile(x) + "</Layer>"));
        const ShapeSketch& outline = job->layers[layerNamed(*job, "X")].outline;
        QCOMPARE(outline.contourCount(), contours);
        QCOMPARE(boxOf(outline), (Box{{0, 0}, {(x + 10) * kMm, 10 * kMm}}));
    }

    void outlinesThatAreUnitedKeepTheirArcs() {
        const auto profile = [](int middle) {
            const std::string x = std::to_string(middle);
            return "<Profile><Polygon><PolyBegin x='" + std::to_string(middle + 5) + "' y='0'/><PolyStepCurve x='" +
                   std::to_string(middle - 5) + "' y='0' centerX='" + x +
                   "' centerY='0' clockwise='false'/><PolyStepCurve x='" + std::to_string(middle + 5) +
                   "' y='0' centerX='" + x + "' centerY='0' clockwise='false'/></Polygon></Profile>";
        };
        const auto job = parse(fileWith(
            {}, {}, "<Layer name='X' layerFunction='PLANE' side='INTERNAL'>" + profile(0) + profile(6) + "</Layer>"));
        const ShapeSketch& outline = job->layers[layerNamed(*job, "X")].outline;
        QCOMPARE(outline.contourCount(), std::size_t{1});
        const model::PathNodes nodes = outline.contour(0);
        QVERIFY(nodes.size() <= 6);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            QVERIFY(isArc(nodes[i].edge));
        }
        QVERIFY(!reports(*job, "straight edges"));
    }

    /// Also once they are in physical order: T, N, B.
    void layersKnowTheirLine() {
        const auto job =
            parse(fileWith({}, {}, "\n\n<Layer name='N' layerFunction='PLANE' side='INTERNAL' polarity='NEGATIVE'/>"));
        QVERIFY(job->layers[layerNamed(*job, "N")].isNegative);
        QCOMPARE(job->layers[layerNamed(*job, "N")].line, 3U);
        QCOMPARE(job->layers[layerNamed(*job, "B")].line, 1U);
    }
};

QTEST_APPLESS_MAIN(LayerListTest)
#include "layer_list_test.moc"
