// On which layers of a panel those of a flipped copy lie.
#include "model/board/flip.h"

#include <QtTest>

using namespace model;

class FlipTest : public QObject {
    Q_OBJECT

    static std::vector<Layer> copperLayers(std::size_t count) {
        std::vector<Layer> layers(count);
        for (Layer& layer : layers) {
            layer.type = LayerType::Signal;
        }
        setOpposites(layers);
        return layers;
    }

private slots:
    void copperIsPairedFromTheOutside() {
        const std::vector<Layer> layers = copperLayers(3);
        QCOMPARE(layers[0].opposite, LayerId{std::size_t{2}});
        QCOMPARE(layers[1].opposite, LayerId{std::size_t{1}});
        QCOMPARE(layers[2].opposite, LayerId{std::size_t{0}});
    }

    void oneCopperLayerLiesOnTheOtherSide() { QVERIFY(!copperLayers(1).front().opposite.isValid()); }
};

QTEST_APPLESS_MAIN(FlipTest)
#include "flip_test.moc"
