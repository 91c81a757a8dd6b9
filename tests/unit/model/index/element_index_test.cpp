#include "model/index/element_index.h"

#include <QtTest>
#include <algorithm>
#include <random>

#include "tests/unit/model/hand_made.h"

using namespace hand_made;
using model::Box;
using model::ElementId;
using model::LayerId;
using model::LayerType;

namespace {

constexpr std::array<StackLayer, 3> kStackup{{{"top", LayerType::Signal, 1'600 * kUm, 35 * kUm, 2},
                                              {"empty", LayerType::Signal, 800 * kUm, 35 * kUm, 1},
                                              {"bottom", LayerType::Signal, 0, 35 * kUm, 0}}};

}  // namespace

class ElementIndexTest : public QObject {
    Q_OBJECT

private slots:
    /// Each visit finds exactly the elements whose boxes meet the one that is asked for.
    void findsWhatLiesThere() {
        std::mt19937 random(3);
        model::DocumentBuilder builder;
        addLayers(builder, kStackup);
        const auto anywhere = [&random] { return static_cast<model::Nm>(random() % (20 * kMm)); };
        for (const std::size_t layer : {std::size_t{0}, std::size_t{2}}) {
            builder.beginLayer(LayerId{layer});
            for (int i = 0; i < 300; ++i) {
                builder.addCircle({{anywhere(), anywhere()}, 500 * kUm, 0}, {});
            }
        }
        const model::Document& document = builder.soFar();
        std::vector<Box> boxes;
        for (std::size_t row = 0; row < document.elements.size(); ++row) {
            boxes.push_back(document.boxOf(ElementId{row}));
        }
        const model::ElementIndex index(document, boxes);
        for (int i = 0; i < 50; ++i) {
            Box asked;
            asked.include(model::Point{anywhere(), anywhere()});
            asked.include(model::Point{anywhere(), anywhere()});
            std::vector<std::uint32_t> all;
            index.visit(asked, [&all](std::uint32_t row) { all.push_back(row); });
            std::ranges::sort(all);
            std::vector<std::uint32_t> expected;
            std::vector<std::vector<std::uint32_t>> byLayer(kStackup.size());
            for (std::uint32_t row = 0; row < boxes.size(); ++row) {
                if (boxes[row].meets(asked)) {
                    expected.push_back(row);
                    byLayer[document.elements.layer[row].row()].push_back(row);
                }
            }
            QVERIFY(all == expected);
            for (std::size_t layer = 0; layer < kStackup.size(); ++layer) {
                std::vector<std::uint32_t> own;
                index.visit(LayerId{layer}, asked, [&own](std::uint32_t row) { own.push_back(row); });
                std::ranges::sort(own);
                QVERIFY(own == byLayer[layer]);
            }
        }
    }
};

QTEST_APPLESS_MAIN(ElementIndexTest)
#include "element_index_test.moc"
