// IPC-D-356 netlists of real jobs against the images of the same board: every record of a pad or via lies on a pad of
// the net that it names.
#include <QtTest>
#include <algorithm>
#include <map>
#include <vector>

#include "model/board/holes.h"
#include "model/figures/distance.h"
#include "model/formats/gerber/netlist/d356.h"
#include "model/formats/gerber/text/words.h"
#include "model/text/whole_file.h"
#include "tests/boards/gerber_job.h"
#include "tests/locations.h"

using model::gerber::D356Point;

namespace {

namespace fs = std::filesystem;

/// What covers a record's place.
enum class Ground { Nothing, OtherNet, NoNet, OwnNet };

class Pads {
public:
    explicit Pads(const model::Document& board) : m_board(board) {
        for (std::size_t row = 0; row < board.elements.size(); ++row) {
            const model::Layer& layer = board.layer(board.elements.layer[row]);
            if ((board.elements.flags[row] & (model::kPad | model::kHole)) != 0 &&
                (layer.isCopper() || model::isHoles(layer.type))) {
                m_pads.push_back(model::ElementId{row});
            }
        }
    }

    /// The best that lies at a place on the faces it can be reached from.
    [[nodiscard]] Ground at(model::Point p, int access, model::NetId net) const {
        model::FigureTable disc;
        disc.addDisc(p, 0.0);
        Ground best = Ground::Nothing;
        for (const model::ElementId pad : m_pads) {
            if (m_board.boxOf(pad).holds(p) && isReached(pad, access) && covers(pad, disc)) {
                const model::NetId of = m_board.elements.net[pad.row()];
                const Ground ground = !of.isValid() ? Ground::NoNet : of == net ? Ground::OwnNet : Ground::OtherNet;
                best = std::max(best, ground);
            }
        }
        return best;
    }

    /// Does one pad cover both places? Drills may lie beside the middles of their pads.
    [[nodiscard]] bool haveOnePad(model::Point p, model::Point q) const {
        model::FigureTable first;
        first.addDisc(p, 0.0);
        model::FigureTable second;
        second.addDisc(q, 0.0);
        return std::ranges::any_of(m_pads, [&](model::ElementId pad) {
            const model::Box box = m_board.boxOf(pad);
            return box.holds(p) && box.holds(q) && covers(pad, first) && covers(pad, second);
        });
    }

private:
    [[nodiscard]] bool isReached(model::ElementId pad, int access) const {
        const model::Layer& layer = m_board.layer(m_board.elements.layer[pad.row()]);
        const bool isTop = layer.side == model::LayerSide::Top;
        return model::isHoles(layer.type) || access == 0 || (access == 1) == isTop;
    }
    [[nodiscard]] bool covers(model::ElementId pad, const model::FigureTable& disc) const {
        model::FigureTable figures;
        figures.add(m_board, pad);
        return figures.size() > 0 && model::spacingBetween(figures, disc, model::kTouchNm).has_value();
    }

    const model::Document& m_board;
    std::vector<model::ElementId> m_pads;
};

/// How many records of pads and vias with a net there are, and where they lie.
struct Count {
    int records = 0;
    int onOwnNet = 0;
    int onNoNet = 0;
    int onOtherNet = 0;
    int onNothing = 0;
    int unknownNets = 0;  ///< records whose net no net of the board is called like
    int withoutNet = 0;   ///< N/C
    int withoutPad = 0;   ///< of these: nothing there, or a pad of a net with other pins
    int pins = 0;         ///< records that name a pin of a part
    int onOwnPin = 0;     ///< of these: on the pad of that pin

    void add(Ground ground) {
        ++records;
        ++(ground == Ground::OwnNet    ? onOwnNet
           : ground == Ground::NoNet   ? onNoNet
           : ground == Ground::Nothing ? onNothing
                                       : onOtherNet);
    }
};

/// As a record has room for it.
std::string nameOf(std::string_view refdes, std::string_view pin) {
    return model::gerber::upperCase(std::string(refdes.substr(0, 6)) + "-" + std::string(pin.substr(0, 4)));
}

class NetlistCounter {
public:
    NetlistCounter(const model::Document& board, std::vector<D356Point> points)
        : m_board(board), m_pads(board), m_points(std::move(points)) {
        for (const model::Component& part : board.components) {
            for (const model::Pin& pin : board.pinsOf(part)) {
                m_pins.emplace(nameOf(part.refdes, board.text(pin.name)), pin.position);
            }
        }
    }

    Count run() {
        // The document holds the named ones in their order, shifted to the images.
        std::size_t named = 0;
        for (const D356Point& from : m_points) {
            if (from.net >= 0) {
                const model::NetPoint& point = m_board.netPoints[named++];
                m_shift = {point.position.x - from.position.x, point.position.y - from.position.y};
                count(from, point);
            }
        }
        for (const D356Point& from : m_points) {
            if (from.net < 0 && from.isPlated) {
                countWithoutNet(from);
            }
        }
        for (const D356Point& from : m_points) {
            if (!from.refdes.empty() && !from.isVia && !from.pin.empty()) {
                countPin(from);
            }
        }
        return m_count;
    }

private:
    void countPin(const D356Point& from) {
        const model::Point at{from.position.x + m_shift.x, from.position.y + m_shift.y};
        ++m_count.pins;
        const auto [begin, end] = m_pins.equal_range(nameOf(from.refdes, from.pin));
        const bool isThere =
            std::any_of(begin, end, [&](const auto& pin) { return m_pads.haveOnePad(pin.second, at); });
        m_count.onOwnPin += isThere ? 1 : 0;
        if (!isThere) {
            tell(from, "its pin", Ground::Nothing);
        }
    }

    void count(const D356Point& from, const model::NetPoint& point) {
        m_count.unknownNets += point.net.isValid() ? 0 : 1;
        const Ground ground = m_pads.at(point.position, from.access, point.net);
        m_count.add(ground);
        if (ground != Ground::OwnNet) {
            tell(from, m_board.text(point.name), ground);
        }
    }

    void countWithoutNet(const D356Point& from) {
        const model::Point at{from.position.x + m_shift.x, from.position.y + m_shift.y};
        ++m_count.withoutNet;
        if (m_pads.at(at, from.access, {}) == Ground::Nothing) {
            ++m_count.withoutPad;
            tell(from, "N/C", Ground::Nothing);
        }
    }

    static void tell(const D356Point& from, std::string_view net, Ground ground) {
        qInfo("line %u: %s %s-%s at %.4f, %.4f mm, access %d: %s", from.line, std::string(net).c_str(),
              from.refdes.c_str(), from.pin.c_str(), from.position.x / 1e6, from.position.y / 1e6, from.access,
              ground == Ground::Nothing ? "nothing"
              : ground == Ground::NoNet ? "a pad without a net"
                                        : "a pad of another net");
    }

    const model::Document& m_board;
    Pads m_pads;
    std::multimap<std::string, model::Point> m_pins;
    std::vector<D356Point> m_points;
    model::Point m_shift;
    Count m_count;
};

}  // namespace

class NetlistBoardsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        if (!fs::exists(locations::boards() / "formats")) {
            QSKIP("the folder of boards holds no formats/");
        }
    }

    void recordsLieOnPadsOfTheirNets_data() {
        QTest::addColumn<QString>("job");
        QTest::addColumn<QString>("netlist");
        QTest::addColumn<int>("records");
        QTest::addColumn<int>("withoutNet");
        QTest::addColumn<int>("pins");
        struct Board {
            const char* name;
            int records;
            int withoutNet;
            int pins;
        };
        for (const auto& [name, records, withoutNet, pins] :
             {Board{"StickHub", 360, 0, 273}, Board{"RoyalBlue54L-Feather", 572, 0, 389},
              Board{"kit-dev-coldfire-xilinx_5213", 1069, 9, 823}, Board{"microwave", 0, 8, 8},
              Board{"multichannel_mixer", 309, 47, 327}, Board{"flat_hierarchy", 245, 3, 240},
              Board{"custom_pads_test", 6, 5, 11}}) {
            const QString folder = QString("kicad/") + name + "/" + name;
            QTest::newRow(name) << folder + "-gerbers.zip" << folder + ".d356" << records << withoutNet << pins;
        }
        QTest::newRow("Allegro") << "gerber/allegro.zip"
                                 << "" << 489 << 18 << 266;
    }
    void recordsLieOnPadsOfTheirNets() {
        QFETCH(QString, job);
        QFETCH(QString, netlist);
        QFETCH(int, records);
        QFETCH(int, withoutNet);
        QFETCH(int, pins);
        const fs::path formats = locations::boards() / "formats";
        GerberJob folder;
        QVERIFY(folder.take(formats / job.toStdString()));
        fs::path path = folder.path() / "08_057494d-ipc356.ipc";
        if (!netlist.isEmpty()) {
            path = folder.path() / "board.d356";
            fs::copy_file(formats / netlist.toStdString(), path);
        }
        const auto text = model::readWholeFile(path);
        QVERIFY(text.ok());
        model::Diagnostics diagnostics;
        const model::gerber::D356 read = model::gerber::parseD356(*text, "board.d356", diagnostics);
        const auto board = folder.open();
        QVERIFY(board != nullptr);
        QCOMPARE(static_cast<std::size_t>(std::ranges::count_if(read.points, [](const auto& p) { return p.net >= 0; })),
                 board->netPoints.size());
        const Count count = NetlistCounter(*board, read.points).run();
        QCOMPARE(count.records, records);
        QCOMPARE(count.withoutNet, withoutNet);
        QCOMPARE(count.onOwnNet, count.records);
        QCOMPARE(count.unknownNets, 0);
        QCOMPARE(count.withoutPad, 0);
        QCOMPARE(count.pins, pins);
        QCOMPARE(count.onOwnPin, count.pins);
    }
};

QTEST_APPLESS_MAIN(NetlistBoardsTest)
#include "netlist_boards_test.moc"
