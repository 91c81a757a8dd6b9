#include "render/scene/z_scale.h"

#include <QtTest>

using render::FrameLayer;
using render::scaleHeights;
using render::ZRange;

/// Copper and everything else grow by factors of their own.
class ZScaleTest : public QObject {
    Q_OBJECT

    static std::vector<FrameLayer> stack() {
        std::vector<FrameLayer> layers = {{1.5F, 1.6F}, {0.1F, 1.5F},  {0.0F, 0.1F},
                                          {0.0F, 1.6F}, {1.6F, 1.62F}, {-0.02F, 0.0F}};
        layers[0].isCopper = true;
        layers[2].isCopper = true;
        return layers;
    }

    static bool near(const ZRange& z, float z0, float z1) {
        return std::abs(z.z0 - z0) < 1e-4F && std::abs(z.z1 - z1) < 1e-4F;
    }

private slots:
    void realHeightsStayAsTheyAreToTheBit() {
        const std::vector<ZRange> z = scaleHeights(stack(), {});
        for (std::size_t i = 0; i < z.size(); ++i) {
            QCOMPARE(z[i].z0, stack()[i].z0);
            QCOMPARE(z[i].z1, stack()[i].z1);
        }
    }

    void copperGrowsAndTheRestMovesWithIt() {
        const std::vector<ZRange> z = scaleHeights(stack(), {10.0F, 1.0F});
        QVERIFY(near(z[2], 0.0F, 1.0F));
        QVERIFY(near(z[1], 1.0F, 2.4F));
        QVERIFY(near(z[0], 2.4F, 3.4F));
        QVERIFY(near(z[3], 0.0F, 3.4F));  // barrels reach from face to face
        QVERIFY(near(z[4], 3.4F, 3.42F));
        QVERIFY(near(z[5], -0.02F, 0.0F));
    }

    void dielectricGrowsAlone() {
        const std::vector<ZRange> z = scaleHeights(stack(), {1.0F, 0.5F});
        QVERIFY(near(z[1], 0.1F, 0.8F));
        QVERIFY(near(z[0], 0.8F, 0.9F));
        QVERIFY(near(z[5], -0.01F, 0.0F));
    }
};

QTEST_APPLESS_MAIN(ZScaleTest)
#include "z_scale_test.moc"
