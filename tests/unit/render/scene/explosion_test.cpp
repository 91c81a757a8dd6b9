#include "render/scene/explosion.h"

#include <QtTest>

using namespace render;

class ExplosionTest : public QObject {
    Q_OBJECT

    /// A four-layer board: copper of 0.03 mm at 0, 0.5, 1.0 and 1.5, the laminate between the outer ones, and a drill
    /// through all.
    static std::vector<StackedLayer> fourLayers() {
        return {{{1.5F, 1.53F}}, {{1.0F, 1.03F}}, {{0.5F, 0.53F}},
                {{0.0F, 0.03F}}, {{0.03F, 1.5F}}, {{0.0F, 1.53F}, true, true}};
    }

private slots:
    void nothingMovesWithoutSpread() {
        const auto layers = fourLayers();
        const auto z = explode(layers, 0.0F);
        for (std::size_t i = 0; i < layers.size(); ++i) {
            QCOMPARE(z[i].z0, layers[i].z.z0);
            QCOMPARE(z[i].z1, layers[i].z.z1);
        }
    }

    void stackGrowsBySpreadInOrder() {
        const auto z = explode(fourLayers(), 10.0F);
        QCOMPARE(z[0].z1 - z[3].z0, 11.53F);
        // From the top: copper, copper, laminate, copper, copper.
        QVERIFY(z[0].z0 > z[1].z1 && z[1].z0 > z[4].z1 && z[4].z0 > z[2].z1 && z[2].z0 > z[3].z1);
        QCOMPARE(z[0].z1 - z[0].z0, 0.03F);
    }

    void barrelsStillPassThroughWhatTheySpan() {
        const auto z = explode(fourLayers(), 10.0F);
        QCOMPARE(z[5].z0, z[3].z0);
        QCOMPARE(z[5].z1, z[0].z1);
    }

    void laminateStaysASlab() {
        const auto z = explode(fourLayers(), 10.0F);
        QVERIFY(std::abs((z[4].z1 - z[4].z0) - 1.47F) < 1e-5F);
    }

    void hiddenLayersLeaveNoGap() {
        auto layers = fourLayers();
        layers[1].isVisible = false;
        layers[4].isVisible = false;
        const auto z = explode(layers, 10.0F);
        QVERIFY(std::abs((z[0].z0 - z[2].z1) - (0.97F + 5.0F)) < 1e-5F);
        QVERIFY(std::abs((z[2].z0 - z[3].z1) - (0.47F + 5.0F)) < 1e-5F);
    }

    void layersAtOneHeightStayTogether() {
        const auto z = explode(std::vector<StackedLayer>{{{0, 1}}, {{0, 1}}, {{2, 3}}}, 4.0F);
        QCOMPARE(z[0].z0, z[1].z0);
        QCOMPARE(z[2].z0 - z[0].z0, 6.0F);
    }

    void aSingleLayerDoesNotMove() {
        const auto z = explode(std::vector<StackedLayer>{{{1, 2}}}, 4.0F);
        QCOMPARE(z[0].z0, 1.0F);
    }
};

QTEST_APPLESS_MAIN(ExplosionTest)
#include "explosion_test.moc"
