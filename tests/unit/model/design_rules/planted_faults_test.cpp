// A thousand faults of each kind of rule, each planted at random beside something sound that looks the same: every
// fault is found, and nothing else.
#include <QtTest>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <set>

#include "model/board/document_builder.h"
#include "model/design_rules/design_rule_check.h"
#include "tests/unit/model/hand_made.h"

using namespace hand_made;
using model::DocumentBuilder;
using model::LayerId;
using model::NetId;
using model::Nm;
using model::Point;
using model::Rule;
using model::RuleKind;

namespace {

constexpr int kFaults = 1000;
constexpr int kColumns = 50;
constexpr Nm kLeast = 200 * kUm;
constexpr int kMostRatio = 8;  ///< of a hole of kLeast through the board
constexpr Nm kRounding = 3;    ///< nm: ends of what is turned are rounded

/// A place on the board with axes of its own, turned at random.
struct Cell {
    Point origin;
    double turn = 0.0;

    [[nodiscard]] Point at(double x, double y) const {
        return {origin.x + static_cast<Nm>(std::lround(x * std::cos(turn) - y * std::sin(turn))),
                origin.y + static_cast<Nm>(std::lround(x * std::sin(turn) + y * std::cos(turn)))};
    }
};

/// A board to plant on: layers in the order of a stack, filled one after the other.
class Garden {
public:
    Garden() {
        m_layers = {addLayer(m_builder, "silk", model::LayerType::SilkScreen),
                    addLayer(m_builder, "mask", model::LayerType::SolderMask),
                    addLayer(m_builder, "top", model::LayerType::Signal),
                    addLayer(m_builder, "bottom", model::LayerType::Signal)};
        m_layers.push_back(addDrill(m_builder, m_layers[Top], m_layers[Top + 1]));
        m_builder.layer(m_layers[Drill]).thickness = kMostRatio * kLeast;
    }

    /// What comes now has nets of its own: some rules say one location for two nets.
    void beginCell(int cell) {
        m_nets = {m_builder.addNet("A" + std::to_string(cell)), m_builder.addNet("B" + std::to_string(cell))};
    }

    enum Layer { Silk, Mask, Top, Drill = 4 };
    enum Net { A, B, None };

    void track(Layer layer, Point a, Point b, Nm width, Net net) {
        later(layer, [=, this, id = netOf(net)] { m_builder.addLine({a, b, width, 0}, of(id)); });
    }
    void disc(Layer layer, Point at, Nm diameter, Net net, int flags = 0) {
        later(layer, [=, this, id = netOf(net)] { m_builder.addCircle({at, diameter, 0}, of(id, flags)); });
    }
    void pad(Point at, Nm diameter, Net net) { disc(Top, at, diameter, net, model::kPad); }
    void hole(Point at, Nm diameter, Net net, bool isPlated = false) {
        const int flags = model::kHole | (isPlated ? model::kPlated : 0);
        later(Drill, [=, this, id = netOf(net)] { m_builder.addCircle({at, diameter, diameter}, of(id, flags)); });
    }

    void slot(Point a, Point b, Nm width) {
        later(Drill, [=, this] { m_builder.addLine({a, b, width, width}, of({}, model::kHole)); });
    }

    [[nodiscard]] std::shared_ptr<const model::Document> finish(Point min, Point max) {
        m_builder.setProfile(m_builder.addShape(rectangle(min, max)));
        for (const Layer layer : {Silk, Mask, Top, Drill}) {
            m_builder.beginLayer(m_layers[static_cast<std::size_t>(layer)]);
            for (const auto& [of, add] : m_later) {
                if (of == layer) {
                    add();
                }
            }
        }
        return m_builder.finish();
    }

private:
    [[nodiscard]] NetId netOf(Net net) const { return net == None ? NetId{} : m_nets[static_cast<std::size_t>(net)]; }
    void later(Layer layer, std::function<void()> add) { m_later.emplace_back(layer, std::move(add)); }

    DocumentBuilder m_builder;
    std::vector<LayerId> m_layers;
    std::vector<NetId> m_nets;
    std::vector<std::pair<Layer, std::function<void()>>> m_later;
};

using Random = std::mt19937;

double between(Random& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

/// Too small, or just enough.
double sizeFor(Random& random, bool isFault, double most = 1.5) {
    return isFault ? between(random, 0.02, 1.0) * double(kLeast) - kRounding
                   : between(random, 1.0, most) * double(kLeast) + kRounding;
}

using Plant = void (*)(Garden& garden, const Cell& cell, Random& random, bool isFault);

void plantSpacing(Garden& garden, const Cell& cell, Random& random, bool isFault, Garden::Net second) {
    const double gap = sizeFor(random, isFault);
    garden.track(Garden::Top, cell.at(0, 0), cell.at(600e3, 0), 150 * kUm, Garden::A);
    garden.disc(Garden::Top, cell.at(300e3, 75e3 + 50e3 + gap), 100 * kUm, second);
}

void plantCopper(Garden& garden, const Cell& cell, Random& random, bool isFault) {
    plantSpacing(garden, cell, random, isFault, Garden::B);
}

void plantOwnCopper(Garden& garden, const Cell& cell, Random& random, bool isFault) {
    plantSpacing(garden, cell, random, isFault, Garden::A);
}

void plantNearHole(Garden& garden, const Cell& cell, Random& random, bool isFault) {
    const double gap = sizeFor(random, isFault);
    garden.track(Garden::Top, cell.at(0, 0), cell.at(600e3, 0), 150 * kUm, Garden::A);
    garden.hole(cell.at(300e3, 75e3 + 150e3 + gap), 300 * kUm, Garden::None);
}

/// The outline is that of all cells of a row: see boardOf.
void plantNearEdge(Garden& garden, const Cell& cell, Random& random, bool isFault) {
    const double gap = sizeFor(random, isFault);
    garden.disc(Garden::Top, {cell.origin.x, static_cast<Nm>(gap) + 50 * kUm}, 100 * kUm, Garden::A);
}

void plantHoles(Garden& garden, const Cell& cell, Random& random, bool isFault) {
    const double gap = sizeFor(random, isFault);
    garden.hole(cell.at(0, 0), 300 * kUm, Garden::A);
    garden.hole(cell.at(300e3 + gap, 0), 300 * kUm, Garden::B);
}

void plantRing(Garden& garden, const Cell& cell, Random& random, bool isFault) {
    const double ring = sizeFor(random, isFault);
    const double offset = between(random, 0.0, 100e3);
    garden.hole(cell.at(offset, 0), 300 * kUm, Garden::A, true);
    garden.pad(cell.at(0, 0), 2 * static_cast<Nm>(150e3 + ring + offset), Garden::A);
}

void plantHole(Garden& garden, const Cell& cell, Random& random, bool isFault) {
    const bool isPlated = random() % 2 == 0;
    garden.hole(cell.at(0, 0), static_cast<Nm>(sizeFor(random, isFault)), Garden::A, isPlated);
}

void plantSlot(Garden& garden, const Cell& cell, Random& random, bool isFault) {
    const double half = between(random, 0.0, 200e3);
    garden.slot(cell.at(-half, 0), cell.at(half, 0), static_cast<Nm>(sizeFor(random, isFault)));
}

void plantDeepHole(Garden& garden, const Cell& cell, Random& random, bool isFault) {
    garden.hole(cell.at(0, 0), static_cast<Nm>(sizeFor(random, isFault)), Garden::A, true);
}

void plantSliver(Garden& garden, const Cell& cell, Random& random, bool isFault) {
    const double gap = sizeFor(random, isFault);
    garden.track(Garden::Mask, cell.at(0, 0), cell.at(600e3, 0), 150 * kUm, Garden::None);
    garden.disc(Garden::Mask, cell.at(300e3, 75e3 + 50e3 + gap), 100 * kUm, Garden::None);
}

void plantOpening(Garden& garden, const Cell& cell, Random& random, bool isFault) {
    const double ring = sizeFor(random, isFault);
    const double offset = between(random, 0.0, 100e3);
    garden.pad(cell.at(offset, 0), 300 * kUm, Garden::A);
    garden.disc(Garden::Mask, cell.at(0, 0), 2 * static_cast<Nm>(150e3 + ring + offset), Garden::None);
}

void plantForeign(Garden& garden, const Cell& cell, Random& random, bool isFault) {
    const double gap = sizeFor(random, isFault);
    garden.pad(cell.at(0, 0), 300 * kUm, Garden::A);
    garden.disc(Garden::Mask, cell.at(0, 0), 400 * kUm, Garden::None);
    garden.track(Garden::Top, cell.at(-300e3, 200e3 + gap + 50e3), cell.at(300e3, 200e3 + gap + 50e3), 100 * kUm,
                 Garden::B);
}

void plantSilkscreen(Garden& garden, const Cell& cell, Random& random, bool isFault) {
    const double gap = sizeFor(random, isFault);
    garden.pad(cell.at(0, 0), 300 * kUm, Garden::A);
    garden.disc(Garden::Mask, cell.at(0, 0), 400 * kUm, Garden::None);
    garden.track(Garden::Silk, cell.at(-300e3, 150e3 + gap + 60e3), cell.at(300e3, 150e3 + gap + 60e3), 120 * kUm,
                 Garden::None);
}

void plantTrack(Garden& garden, const Cell& cell, Random& random, bool isFault) {
    garden.track(Garden::Top, cell.at(0, 0), cell.at(600e3, 0), static_cast<Nm>(sizeFor(random, isFault)), Garden::A);
}

void plantAngle(Garden& garden, const Cell& cell, Random& random, bool isFault) {
    const double angle = (isFault ? between(random, 20, 88) : between(random, 90.5, 180)) * std::numbers::pi / 180;
    garden.track(Garden::Top, cell.at(0, 0), cell.at(900e3, 0), 100 * kUm, Garden::A);
    garden.track(Garden::Top, cell.at(0, 0), cell.at(900e3 * std::cos(angle), 900e3 * std::sin(angle)), 100 * kUm,
                 Garden::A);
}

void plantIsland(Garden& garden, const Cell& cell, Random& random, bool isFault) {
    garden.track(Garden::Top, cell.at(0, 0), cell.at(500e3, 0), 100 * kUm, Garden::A);
    const double gap = between(random, 1.0, 50e3);
    garden.pad(cell.at(500e3 + 50e3 + 100e3 + (isFault ? gap : -gap), 0), 200 * kUm, Garden::A);
}

/// Two pads on either side of a round hole: along tangents and around it, in closed form.
void plantCreepage(Garden& garden, const Cell& cell, Random& random, bool isFault) {
    constexpr double kPad = 50e3;
    constexpr double kWay = 3e6;
    const double radius = between(random, 550e3, 800e3);
    const auto wayOf = [&](double away) {
        return 2 * (std::sqrt(away * away - radius * radius) - kPad) +
               radius * (std::numbers::pi - 2 * std::acos(radius / away));
    };
    double low = radius + kPad;
    double high = 2e6;
    const double wanted = isFault ? between(random, 0.9, 1.0) * kWay - 20e3 : kWay + 20e3;
    for (int i = 0; i < 60; ++i) {
        (wayOf((low + high) / 2) < wanted ? low : high) = (low + high) / 2;
    }
    garden.hole(cell.at(0, 0), static_cast<Nm>(2 * radius), Garden::None);
    garden.pad(cell.at(-low, 0), 100 * kUm, Garden::A);
    garden.pad(cell.at(low, 0), 100 * kUm, Garden::B);
}

struct Kind {
    Rule rule;
    Plant plant;
    Nm pitch = 2 * kMm;
    int columns = kColumns;
};

std::vector<Kind> kinds() {
    Rule within{RuleKind::CopperToCopper, kLeast, {}};
    within.isSameNet = true;
    Rule deep{RuleKind::AspectRatio, 0, {}};
    deep.mostRatio = kMostRatio;
    return {{{RuleKind::CopperToCopper, kLeast, {}}, plantCopper},
            {within, plantOwnCopper},
            {{RuleKind::CopperToHole, kLeast, {}}, plantNearHole},
            {{RuleKind::CopperToEdge, kLeast, {}}, plantNearEdge, 400 * kUm, 2 * kFaults},
            {{RuleKind::HoleToHole, kLeast, {}}, plantHoles},
            {{RuleKind::AnnularRing, kLeast, {}}, plantRing},
            {{RuleKind::MaskSliver, kLeast, {}}, plantSliver},
            {{RuleKind::MaskToCopper, kLeast, {}}, plantOpening},
            {{RuleKind::MaskToForeign, kLeast, {}}, plantForeign},
            {{RuleKind::SilkToPad, kLeast, {}}, plantSilkscreen},
            {{RuleKind::TrackWidth, kLeast, {}}, plantTrack},
            {{RuleKind::AcuteAngle, 0, {}}, plantAngle, 3 * kMm},
            {{RuleKind::FloatingCopper, 0, {}}, plantIsland},
            {{RuleKind::Creepage, 3 * kMm, {}}, plantCreepage, 10 * kMm},
            {{RuleKind::HoleSize, kLeast, {}}, plantHole},
            {{RuleKind::SlotWidth, kLeast, {}}, plantSlot},
            {deep, plantDeepHole}};
}

using Cells = std::set<int>;

/// In which cell a location is.
int cellAt(const Kind& kind, model::PointD p) {
    const int column = static_cast<int>(std::lround(p.x / double(kind.pitch)));
    return static_cast<int>(std::lround(p.y / double(kind.pitch))) * kind.columns + column;
}

/// Half of the cells have a fault, in random order.
Cells plantAll(const Kind& kind, Garden& garden, Random& random) {
    std::vector<int> cells(2 * kFaults);
    std::iota(cells.begin(), cells.end(), 0);
    std::shuffle(cells.begin(), cells.end(), random);
    const Cells faults(cells.begin(), cells.begin() + kFaults);
    for (int cell = 0; cell < 2 * kFaults; ++cell) {
        const Point origin{cell % kind.columns * kind.pitch, cell / kind.columns * kind.pitch};
        garden.beginCell(cell);
        kind.plant(garden, {origin, between(random, 0, 2 * std::numbers::pi)}, random, faults.contains(cell));
    }
    return faults;
}

/// The lower edge is that of plantNearEdge when cells lie in one row.
std::shared_ptr<const model::Document> boardOf(const Kind& kind, Garden& garden) {
    const Nm below = kind.columns == 2 * kFaults ? 0 : 10 * kMm;
    const Nm rows = 2 * kFaults / kind.columns;
    return garden.finish({-10 * kMm, -below}, {kind.columns * kind.pitch + 10 * kMm, rows * kind.pitch + 10 * kMm});
}

}  // namespace

class PlantedFaultsTest : public QObject {
    Q_OBJECT

private slots:
    void everyKindHasPlants() {
        std::set<RuleKind> planted;
        for (const Kind& kind : kinds()) {
            planted.insert(kind.rule.kind);
        }
        QCOMPARE(planted.size(), model::kRuleKindCount);
    }

    void faultsAreFoundAndNothingElse_data() {
        QTest::addColumn<int>("row");
        const std::vector<Kind> all = kinds();
        for (int row = 0; row < static_cast<int>(all.size()); ++row) {
            QTest::newRow(model::titleOf(all[static_cast<std::size_t>(row)].rule).c_str()) << row;
        }
    }
    void faultsAreFoundAndNothingElse() {
        QFETCH(int, row);
        const Kind kind = kinds()[static_cast<std::size_t>(row)];
        Random random(static_cast<unsigned>(row) + 1);
        Garden garden;
        const Cells faults = plantAll(kind, garden, random);
        base::Progress progress;
        const auto board = boardOf(kind, garden);
        const auto report = model::checkRules(*board, {{}, {kind.rule}, 0}, progress);
        QVERIFY(report);
        QVERIFY(report->isComplete());
        Cells found;
        for (const model::RuleFinding& finding : report->findings) {
            found.insert(cellAt(kind, finding.spacing.from));
        }
        std::vector<int> missed;
        std::ranges::set_difference(faults, found, std::back_inserter(missed));
        std::vector<int> alarms;
        std::ranges::set_difference(found, faults, std::back_inserter(alarms));
        QVERIFY2(missed.empty(), qPrintable(QStringLiteral("%1 missed").arg(missed.size())));
        QVERIFY2(alarms.empty(), qPrintable(QStringLiteral("%1 false alarms").arg(alarms.size())));
        QCOMPARE(report->findings.size(), std::size_t{kFaults});
    }
};

QTEST_APPLESS_MAIN(PlantedFaultsTest)
#include "planted_faults_test.moc"
