// Maps of panels: every copy has the values of its step, wherever and however it is placed.
#include "model/clearance/board_distances.h"

#include <QtTest>

#include "model/board/document_builder.h"
#include "model/export/clearance_map_export.h"
#include "tests/unit/model/hand_made.h"

using namespace hand_made;
using model::BoardDistances;
using model::BoardElement;
using model::Document;
using model::DocumentBuilder;
using model::ElementId;
using model::LayerId;
using model::MapFrame;
using model::PointD;

namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();
constexpr double kReach = 1e6;

void addOuterLayers(DocumentBuilder& builder) {
    constexpr StackLayer kLayers[] = {{"TOP", model::LayerType::Signal, kMm, 35 * kUm, 1},
                                      {"BOTTOM", model::LayerType::Signal, 0, 35 * kUm, 0}};
    addLayers(builder, kLayers);
}

/// 4 × 2 mm; two tracks 0.3 mm apart on TOP, 0.7 mm on BOTTOM.
std::shared_ptr<const Document> card() {
    DocumentBuilder builder;
    builder.job().step = "card";
    addOuterLayers(builder);
    const model::NetId a = builder.addNet("A");
    const model::NetId b = builder.addNet("B");
    builder.setProfile(builder.addShape(rectangle({0, 0}, {4 * kMm, 2 * kMm})));
    for (const auto& [layer, apart] : {std::pair(0, 300 * kUm), std::pair(1, 700 * kUm)}) {
        builder.beginLayer(LayerId{std::size_t(layer)});
        const model::Nm high = 600 * kUm + apart;
        for (const auto& [y, net] : {std::pair(500 * kUm, a), std::pair(high + 100 * kUm, b)}) {
            model::LineGeometry line;
            line.a = {500 * kUm, y};
            line.b = {3 * kMm, y};
            line.width = 200 * kUm;
            builder.addLine(line, of(net));
        }
    }
    return builder.finish();
}

/// One as it is, one rotated by a quarter, one flipped.
std::shared_ptr<const Document> panel() {
    DocumentBuilder builder;
    builder.job().step = "panel";
    addOuterLayers(builder);
    builder.setProfile(builder.addShape(rectangle({0, 0}, {20 * kMm, 10 * kMm})));
    const std::uint32_t step = builder.addStep(card());
    builder.addInstance({step, {{kMm, kMm}, 0.0, false}, false});
    builder.addInstance({step, {{8 * kMm, 8 * kMm}, 90.0, false}, false});
    builder.addInstance({step, {{18 * kMm, kMm}, 0.0, true}, true});
    return builder.finish();
}

base::Result<BoardDistances> betweenNets(const Document& board, int layer) {
    base::Progress progress;
    return BoardDistances::betweenNets(board, LayerId{std::size_t(layer)}, progress);
}

/// Between the two tracks of a card.
constexpr PointD kBetween{2.0e6, 0.75e6};

}  // namespace

class BoardDistancesTest : public QObject {
    Q_OBJECT

private slots:
    void everyCopyHasTheSpacingsOfItsStep() {
        const auto board = panel();
        const model::StepTree tree = model::unfoldCopies(*board);
        const auto top = betweenNets(*board, 0);
        const auto bottom = betweenNets(*board, 1);
        QVERIFY(top && bottom);
        QCOMPARE(top->copyCount(), std::size_t{3});
        for (const model::StepCopy& copy : tree.copies) {
            if (copy.step == 0) {
                continue;
            }
            const PointD at = copy.placement.apply(kBetween);
            QCOMPARE(std::llround(top->at(at, kReach)), copy.isFlipped ? 700'000 : 300'000);
            QCOMPARE(std::llround(bottom->at(at, kReach)), copy.isFlipped ? 300'000 : 700'000);
        }
        QCOMPARE(top->at({16e6, 9e6}, kReach), kEndless);  // of no copy
        QVERIFY(top->note().find("across copies") != std::string::npos);
    }

    void theMapHasInEveryCellWhatIsAtItsMiddle() {
        const auto board = panel();
        base::Progress progress;
        for (const int layer : {0, 1}) {
            const auto distances = betweenNets(*board, layer);
            const MapFrame frame{{123.0, 456.0}, 40'000.0, 500, 250};
            const auto map = distances->map(frame, kReach, progress, model::MapDetail::Nets);
            QVERIFY(map);
            std::array<int, 4> cellsOf{};
            for (std::uint32_t row = 0; row < frame.height; ++row) {
                for (std::uint32_t column = 0; column < frame.width; ++column) {
                    const std::size_t cell = std::size_t{row} * frame.width + column;
                    const double expected = distances->at(frame.centreOf(column, row), kReach);
                    QVERIFY(map->nm[cell] == expected || std::abs(map->nm[cell] - expected) < 1.0);
                    if (map->nm[cell] > 0.0F && map->nm[cell] < kReach) {
                        ++cellsOf[map->nets[cell].copy];
                        QVERIFY(map->nets[cell].nearest.isValid() && map->nets[cell].other.isValid());
                        QVERIFY(map->nets[cell].nearest != map->nets[cell].other);
                    }
                }
            }
            QCOMPARE(cellsOf[0], 0);
            QVERIFY(std::min({cellsOf[1], cellsOf[2], cellsOf[3]}) > 100);
        }
    }

    void distancesToTargetsStayInTheCopyOfTheTarget() {
        const auto board = panel();
        const model::StepTree tree = model::unfoldCopies(*board);
        const BoardElement target{2, ElementId{std::size_t{0}}};
        const auto distances = BoardDistances::toTargets(*board, LayerId{std::size_t{0}}, std::vector{target});
        QVERIFY(distances);
        QCOMPARE(std::llround(distances->at(tree.copies[2].placement.apply(kBetween), kReach)), 150'000);
        QCOMPARE(distances->at(tree.copies[1].placement.apply(kBetween), kReach), kEndless);
        // The bottom of a flipped copy lies on TOP of the panel, its top does not.
        const std::vector<BoardElement> flipped{{3, ElementId{std::size_t{0}}}};
        QVERIFY(!BoardDistances::toTargets(*board, LayerId{std::size_t{0}}, flipped));
        QVERIFY(BoardDistances::toTargets(*board, LayerId{std::size_t{1}}, flipped));
    }

    void aBoardByItselfIsItsField() {
        const auto board = card();
        const auto distances = betweenNets(*board, 0);
        QVERIFY(distances);
        QCOMPARE(distances->note(), std::string());
        QVERIFY(distances->extent().min == board->board.min && distances->extent().max == board->board.max);
        QCOMPARE(std::llround(distances->at(kBetween, kReach)), 300'000);
    }

    void aPanelWithoutTwoNetsIsRefused() {
        DocumentBuilder builder;
        addOuterLayers(builder);
        const auto none = betweenNets(*builder.finish(), 0);
        QVERIFY(!none);
        QCOMPARE(none.error().text, std::string("TOP has no copper of two nets"));
    }

    void theTableNamesCopyAndNets() {
        const auto board = panel();
        base::Progress progress;
        const LayerId top{std::size_t{0}};
        const auto distances = betweenNets(*board, 0);
        const auto map =
            distances->map({{3e6 - 500, 1.65e6 - 500}, 1000.0, 1, 1}, kReach, progress, model::MapDetail::Nets);
        QCOMPARE(model::clearanceMapCsv(*board, top, *map),
                 std::string("step,copy,layer,x_nm,y_nm,spacing_nm,net_a,net_b\n"
                             "card,1,TOP,3000000,1650000,300000,A,B\n"));
        const auto far = distances->map({{19e6, 9e6}, 1000.0, 2, 2}, kReach, progress, model::MapDetail::Nets);
        QCOMPARE(model::clearanceMapCsv(*board, top, *far), std::string(model::clearanceMapCsv(*board, top, {})));
    }
};

QTEST_GUILESS_MAIN(BoardDistancesTest)
#include "board_distances_test.moc"
