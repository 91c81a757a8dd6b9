#include "model/index/joined_pads.h"

#include <QtTest>

#include "tests/unit/model/measure/measure_fixture.h"

using namespace model;
using namespace measuring;

namespace {

/// Pads of 1 mm, and holes of 0.4 mm. Layers are drawn in their order.
struct Board {
    DocumentBuilder builder;
    NetId n, m;

    Board() {
        addLayers(builder);
        n = builder.addNet("N");
        m = builder.addNet("M");
    }
    ElementId pad(Point at, NetId net) { return builder.addCircle({at, kMm, 0}, of(net, kPad)); }
    ElementId hole(Point at, NetId net, int flags = kHole | kPlated) {
        return builder.addCircle({at, 400'000, 300'000}, of(net, flags));
    }
};

}  // namespace

class JoinedPadsTest : public QObject {
    Q_OBJECT

private slots:
    void aPlatedHoleJoinsThePadsAroundIt() {
        Board board;
        board.builder.beginLayer(LayerId{Top});
        const ElementId top = board.pad({0, 0}, board.n);
        board.builder.beginLayer(LayerId{Inner});
        const ElementId inner = board.pad({100'000, 0}, board.n);  // off centre
        board.builder.beginLayer(LayerId{Bottom});
        const ElementId bottom = board.pad({0, 0}, board.n);
        board.pad({3 * kMm, 0}, board.n);
        board.builder.beginLayer(LayerId{Drill});
        board.hole({0, 0}, board.n);
        board.hole({3 * kMm, 0}, board.n);
        const auto index = indexed(board.builder.finish());
        QCOMPARE(joinedPads(*index, {0, inner}), (std::vector<BoardElement>{{0, top}, {0, inner}, {0, bottom}}));
    }

    void nothingElseDoes() {
        Board board;
        constexpr Point kWithoutHole{0, 0};
        constexpr Point kUnplated{5 * kMm, 0};
        constexpr Point kOfTwoNets{10 * kMm, 0};
        board.builder.beginLayer(LayerId{Top});
        std::vector<ElementId> alone;
        for (const Point at : {kWithoutHole, kUnplated, kOfTwoNets}) {
            alone.push_back(board.pad(at, board.n));
        }
        board.builder.beginLayer(LayerId{Bottom});
        board.pad(kWithoutHole, board.n);
        board.pad(kUnplated, board.n);
        board.pad(kOfTwoNets, board.m);
        board.builder.beginLayer(LayerId{Drill});
        board.hole(kUnplated, board.n, kHole);
        alone.push_back(board.hole(kOfTwoNets, board.n));
        const auto index = indexed(board.builder.finish());
        for (const ElementId id : alone) {
            QCOMPARE(joinedPads(*index, {0, id}), (std::vector<BoardElement>{{0, id}}));
        }
    }
};

QTEST_APPLESS_MAIN(JoinedPadsTest)
#include "joined_pads_test.moc"
