// Components, their pins and bodies, and netlists: from the files to the document.
#include "model/formats/odb/components/components.h"
#include "model/formats/odb/components/netlist.h"
#include "model/index/pin_finder.h"
#include "tests/unit/model/formats/odb/odb_testing.h"

using namespace odb_testing;
using model::Diagnostics;
using model::Document;
using model::LayerSide;
using model::MountType;
using model::Point;
using model::odb::Unit;

namespace {

/// A job with one package of two pins at (-1, 0) and (2, 1) mm, and these components on both sides.
void writeParts(const Folder& folder, const std::string& top, const std::string& bottom,
                const std::string& netlist = {}) {
    folder.write(
        "matrix/matrix",
        matrixOf({{"COMPONENT", "comp_+_top"}, {"SIGNAL", "TOP"}, {"SIGNAL", "BOT"}, {"COMPONENT", "comp_+_bot"}}));
    folder.write("steps/board/profile", "UNITS=MM\nS P 0\nOB 0 0 I\nOS 100 0\nOS 100 100\nOS 0 100\nOS 0 0\nOE\nSE\n");
    folder.write("steps/board/eda/data",
                 "UNITS=MM\nLYR TOP BOT\nNET A\nSNT TOP T 0 0\nFID C 0 0\nSNT TOP T 9 9\nNET B\nSNT VIA\nFID C 0 1\n"
                 "PKG P1 1 -2 -2 3 2\nRC -2 -2 5 4\nPIN 1 S -1 0 0 E S\nCR -1 0 0.2\nPIN 2 T 2 1 0 E S\n"
                 "FGR TEXT\nPRP string 'hello'\nFID C 0 2\nFID C 0 3\nFID C 0 4\nFID C 0 99\n");
    folder.write("steps/board/layers/top/features",
                 "UNITS=MM\n$0 r1000\n$1 r100\nP 9 20 0 P 0 0\nP 50 50 0 P 0 0\n"
                 "L 1 1 2 1 1 P 0\nL 2 1 3 1 1 P 0\nP 5 5 0 P 0 0\n");
    folder.write("steps/board/layers/comp_+_top/components", "UNITS=MM\n" + top);
    folder.write("steps/board/layers/comp_+_bot/components", "UNITS=MM\n" + bottom);
    if (!netlist.empty()) {
        folder.write("steps/board/netlists/cadnet/netlist", netlist);
    }
}

std::string netNameOf(const Document& d, const model::NetPoint& point) {
    return point.net.isValid() ? d.nets[point.net.row()].name : "";
}

}  // namespace

class PartsTest : public QObject {
    Q_OBJECT

private slots:
    void componentsHaveTheirPins() {
        Diagnostics diagnostics;
        const auto components = model::odb::parseComponents(
            "UNITS=INCH\n@0 .comp_height\n# CMP 0\nID=77\nCMP 7 1 -2 90.5 M U1 10\xb5"
            "F ;0=0.1;ID=3\nPRP X 'TOP ; y'\n"
            "TOP 0 1 -2 90.5 M 12 0 A1\nTOP 1 1 -1 0 N -1 0\nCMP -1 0 0 0 N R1 ???\n",
            "components", Unit::Millimetre, {}, diagnostics);
        QCOMPARE(components.size(), std::size_t{2});
        QCOMPARE(components[0].package, 7);
        QCOMPARE(components[0].position, (Point{25'400'000, -50'800'000}));
        QCOMPARE(components[0].clockwiseDeg, 90.5);
        QVERIFY(components[0].isMirrored);
        QCOMPARE(components[0].height, 2'540'000);
        QCOMPARE(components[0].part, std::string("10\xc2\xb5"
                                                 "F"));
        QCOMPARE(components[0].properties,
                 (std::vector<model::odb::TextProperty>{{".comp_height", "0.1"}, {"X", "TOP ; y"}}));
        QCOMPARE(components[0].pins.size(), std::size_t{2});
        QCOMPARE(components[0].pins[0].net, 12);
        QCOMPARE(components[0].pins[0].name, std::string("A1"));
        QCOMPARE(components[0].pins[1].net, -1);
        QVERIFY(components[0].pins[1].name.empty());
        QVERIFY(components[1].pins.empty());
        QVERIFY(diagnostics.entries().empty());
    }

    /// Allegro writes `???` for every part, and what it is as a property.
    void aPartWithoutANameHasThatOfItsProperty() {
        Diagnostics diagnostics;
        const auto components = model::odb::parseComponents(
            "UNITS=MM\nCMP 0 0 0 0 N U1 ???\nPRP PART_NAME 'XR20M1170'\nCMP 0 1 0 0 N U2 LM317\nPRP PART_NAME 'other'\n"
            "CMP 0 2 0 0 N U3 ???\nPRP VALUE '1k'\nCMP 0 3 0 0 N U4\nPRP PART_NAME 'X'\n",
            "components", Unit::Millimetre, {}, diagnostics);
        QCOMPARE(components.size(), std::size_t{4});
        QCOMPARE(components[0].part, std::string("XR20M1170"));
        QCOMPARE(components[1].part, std::string("LM317"));
        QCOMPARE(components[2].part, std::string("???"));
        QCOMPARE(components[3].part, std::string("X"));
        QCOMPARE(diagnostics.entries().size(), std::size_t{1});
        QCOMPARE(diagnostics.entries()[0].severity, model::Severity::Info);
        QCOMPARE(diagnostics.entries()[0].line, 2U);
    }

    void aBadComponentTakesItsPinsWithIt() {
        Diagnostics diagnostics;
        const auto components = model::odb::parseComponents(
            "U MM\nCMP x 0 0 0 N R1 p\nTOP 0 0 0 0 N 1 0 1\nCMP 0 0 0 0 N R2 p\nTOP 0 a\nFOO 1\nCPN 12\n", "components",
            Unit::Inch, {}, diagnostics);
        QCOMPARE(components.size(), std::size_t{1});
        QVERIFY(components[0].pins.empty());
        QVERIFY(findDiagnostic(diagnostics, "CMP record is unreadable") != nullptr);
        QVERIFY(findDiagnostic(diagnostics, "TOP record is unreadable") != nullptr);
        QVERIFY(findDiagnostic(diagnostics, "unknown kind") != nullptr);
        QVERIFY(findDiagnostic(diagnostics, "bill of materials") != nullptr);
    }

    void componentsThatCannotBeAsWrittenAreReported() {
        const Folder folder;
        writeParts(folder,
                   "@0 .comp_height\n@1 .comp_ignore\nCMP 7 5 5 0 N U1 c\nCMP 0 10 20 400 N U2 c ;0=-3\n"
                   "TOP 9 9 20 0 N 99 0 1\nTOP -1 9 20 0 N -1 0 2\nCMP -1 1 1 360 N U2 c ;1\nCMP -1 1 1 -90 N R1 c\n",
                   "");
        const auto d = read(folder.path());
        const auto lineOf = [&](const char* text) {
            const auto* const entry = findDiagnostic(d->diagnostics, text);
            return entry != nullptr && entry->file.ends_with("components") && entry->count == 1 ? entry->line : 0U;
        };
        QCOMPARE(lineOf("a package that eda/data does not have"), 4U);
        QCOMPARE(lineOf(".comp_height is negative"), 5U);
        QCOMPARE(lineOf("package has no pin of that number"), 6U);
        QCOMPARE(lineOf("no net of that number"), 6U);
        QCOMPARE(lineOf("the same reference designator"), 8U);
        QCOMPARE(lineOf(".comp_ignore"), 8U);
        const auto* const turned = findDiagnostic(d->diagnostics, "not within 0 and 360 degrees");
        QVERIFY(turned != nullptr && turned->line == 5 && turned->count == 2);
        QCOMPARE(d->components.size(), std::size_t{4});
        QCOMPARE(d->components[1].height, 0);
        QCOMPARE(d->components[1].placement.clockwiseDeg, 40.0);
        QCOMPARE(d->components[3].placement.clockwiseDeg, 270.0);
    }

    void aPlacementTakesThePackageToTheBoard() {
        const Folder folder;
        // Turned clockwise by 90°: (x, y) becomes (y, -x).
        writeParts(folder,
                   "@0 .comp_height\n@1 .comp_mount_type\n@2 .no_pop\n"
                   "CMP 0 10 20 0 N U1 chip ;0=1.5,1=1\nPRP MPN 'X1'\nTOP 0 9 20 0 N 0 0 A\nTOP 1 12 21 0 N 1 0\n"
                   "CMP 0 40 20 90 N U2 chip ;2\nTOP 0 40 21 0 N 0 1 1\nTOP 1 41 18 0 N -1 0 2\n",
                   "");
        const auto d = read(folder.path());
        QCOMPARE(d->components.size(), std::size_t{2});
        const model::Component& u1 = d->components[0];
        QVERIFY(!u1.placement.isMirrored);
        QCOMPARE(u1.height, 1'500'000);
        QCOMPARE(u1.mount, MountType::Surface);
        QVERIFY(u1.isPopulated && !d->components[1].isPopulated);
        const auto properties = d->propertiesOf(u1.properties);
        QCOMPARE(properties.size(), std::size_t{3});
        QCOMPARE(d->text(properties[2].name), std::string("MPN"));
        QCOMPARE(d->text(properties[2].value), std::string("X1"));
        QCOMPARE(properties[1].name, d->propertiesOf(u1.properties)[1].name);
        const model::Package& package = d->packages[u1.package.row()];
        QCOMPARE(package.name, std::string("P1"));
        QCOMPARE(d->shapes.shapes[package.body.row()].box,
                 (model::Box{{-2'000'000, -2'000'000}, {3'000'000, 2'000'000}}));
        QCOMPARE(package.pins.count, 2U);
        QVERIFY(d->packagePins[package.pins.first].outline.isValid());
        QVERIFY(!d->packagePins[package.pins.first + 1].outline.isValid());
        QCOMPARE(d->pinsOf(u1)[0].net, d->findNet("A"));
        QCOMPARE(d->text(d->pinsOf(u1)[0].name), std::string("A"));
        QCOMPARE(d->text(d->pinsOf(u1)[1].name), std::string("2"));
        QCOMPARE(d->pinsOf(d->components[1])[0].component, model::ComponentId{1});
        QVERIFY(findDiagnostic(d->diagnostics, "do not lie where its package") == nullptr);
    }

    void thePinsDecideWhetherTheBottomIsMirrored_data() {
        QTest::addColumn<QString>("components");
        QTest::addColumn<bool>("isMirrored");
        // The flag says the opposite of what the pins show: (x, y) → (-x, y), or as seen from the top.
        QTest::addRow("mirrored, flag N") << "CMP 0 10 20 0 N U1 c\nTOP 0 11 20 0 N 0 0 1\nTOP 1 8 21 0 N 0 0 2\n"
                                          << true;
        QTest::addRow("plain, flag N") << "CMP 0 10 20 0 N U1 c\nTOP 0 9 20 0 N 0 0 1\nTOP 1 12 21 0 N 0 0 2\n"
                                       << false;
        QTest::addRow("turned, mirrored") << "CMP 0 10 20 90 N U1 c\nTOP 0 10 21 0 N 0 0 1\nTOP 1 9 18 0 N 0 0 2\n"
                                          << true;
        QTest::addRow("no pins") << "CMP 0 10 20 0 N U1 c\n" << true;
    }
    void thePinsDecideWhetherTheBottomIsMirrored() {
        QFETCH(QString, components);
        QFETCH(bool, isMirrored);
        const Folder folder;
        writeParts(folder, "", components.toStdString());
        const auto d = read(folder.path());
        QCOMPARE(d->components.size(), std::size_t{1});
        QCOMPARE(d->components[0].side, LayerSide::Bottom);
        QCOMPARE(d->components[0].placement.isMirrored, isMirrored);
        for (const model::Pin& pin : d->pins) {
            QCOMPARE(d->components[0].placement.apply(d->packagePins[pin.packagePin].position), pin.position);
        }
    }

    void packagesDrawnThroughTheBoardAreFlipped_data() {
        QTest::addColumn<QString>("top");
        QTest::addColumn<std::size_t>("packages");
        QTest::addRow("only on the bottom") << "" << std::size_t{1};
        QTest::addRow("on both sides") << "CMP 0 50 20 0 N U2 c\nTOP 0 49 20 0 N 0 0 1\nTOP 1 52 21 0 N 0 0 2\n"
                                       << std::size_t{2};
    }
    /// KiCad: said to be mirrored, by 90 degrees, with pins that are not.
    void packagesDrawnThroughTheBoardAreFlipped() {
        QFETCH(QString, top);
        QFETCH(std::size_t, packages);
        const Folder folder;
        writeParts(folder, top.toStdString(), "CMP 0 10 20 90 M U1 c\nTOP 0 10 21 0 N 0 0 1\nTOP 1 11 18 0 N 0 0 2\n");
        const auto d = read(folder.path());
        QCOMPARE(d->packages.size(), packages);
        const model::Component& u1 = d->components.back();
        QCOMPARE(u1.refdes, std::string("U1"));
        QVERIFY(u1.placement.isMirrored);
        QCOMPARE(u1.placement.clockwiseDeg, 90.0);
        const model::Package& package = d->packages[u1.package.row()];
        QCOMPARE(package.box, (model::Box{{-2'000'000, -2'000'000}, {3'000'000, 2'000'000}}));
        QCOMPARE(d->packagePins[package.pins.first + 1].position, (Point{2'000'000, -1'000'000}));
        QCOMPARE(d->pinsOf(u1)[1].position, (Point{11'000'000, 18'000'000}));
        for (const model::Pin& pin : d->pins) {
            const model::Component& owner = d->components[pin.component.row()];
            QCOMPARE(owner.placement.apply(d->packagePins[pin.packagePin].position), pin.position);
        }
        QVERIFY(findDiagnostic(d->diagnostics, "do not lie where its package") == nullptr);
    }

    void pinsThatFitNowhereStayAndAreReported() {
        const Folder folder;
        writeParts(folder, "CMP 0 10 20 0 N U1 c\nTOP 0 9 20.002 0 N 0 0 1\nTOP 1 12 21 0 N 0 0 2\n", "");
        const auto d = read(folder.path());
        QCOMPARE(d->pins[0].position, (Point{9'000'000, 20'002'000}));
        const model::Diagnostic* entry = findDiagnostic(d->diagnostics, "do not lie where its package");
        QVERIFY(entry != nullptr);
        QCOMPARE(entry->line, 2U);
    }

    void designatorsInFrontOfPinsAreLeftOut() {
        const Folder folder;
        writeParts(folder,
                   "CMP 0 10 20 0 N U-1 c\nTOP 0 9 20 0 N 0 0 U-1-1\nTOP 1 12 21 0 N 0 0 U-1-1\n"
                   "CMP 0 10 20 0 N U2 c\nTOP 0 9 20 0 N 0 0 U2-\nTOP 1 12 21 0 N 0 0 2\n",
                   "");
        const auto d = read(folder.path());
        std::vector<std::string> names;
        for (const model::Pin& pin : d->pins) {
            names.push_back(d->text(pin.name));
        }
        QCOMPARE(names, (std::vector<std::string>{"1", "U-1-1", "U2-", "2"}));
    }

    void subnetsAreTiedToPinsAndElements() {
        const Folder folder;
        writeParts(folder, "CMP 0 10 20 0 N U1 c\nTOP 0 9 20 0 N 0 0 1\n", "");
        const auto d = read(folder.path());
        const model::ElementId pad = elementOf(*d, "top", 0);
        const model::SubnetId subnet = d->elements.subnet[pad.row()];
        QVERIFY(subnet.isValid());
        QCOMPARE(d->subnets[subnet.row()].kind, model::SubnetKind::PinPads);
        QCOMPARE(d->subnets[subnet.row()].pin, model::PinId{0});
        QCOMPARE(d->subnets[subnet.row()].net, d->findNet("A"));
        QCOMPARE(d->subnets[d->elements.subnet[elementOf(*d, "top", 1).row()].row()].kind, model::SubnetKind::Via);
        QVERIFY(!d->elements.subnet[elementOf(*d, "top", 2).row()].isValid());
        QVERIFY(!d->subnets[1].pin.isValid());  // the job names a component that is not there
    }

    void subnetsCountComponentsThatAreUnreadable() {
        const Folder folder;
        writeParts(folder, "CMP 0 x 20 0 N U1 c\nTOP 0 9 20 0 N 0 0 1\nCMP 0 10 40 0 N U2 c\nTOP 0 9 40 0 N 0 0 1\n",
                   "");
        const auto d = read(folder.path());
        QCOMPARE(d->components.size(), std::size_t{1});
        QCOMPARE(d->components[0].refdes, std::string("U2"));
        QVERIFY(!d->subnets[d->elements.subnet[elementOf(*d, "top", 0).row()].row()].pin.isValid());
    }

    void subnetsCountTheFirstListOfASide() {
        const Folder folder;
        writeParts(folder, "CMP 0 10 20 0 N U1 c\nTOP 0 9 20 0 N 0 0 1\n", "");
        folder.write("matrix/matrix", matrixOf({{"COMPONENT", "comp_+_top"},
                                                {"SIGNAL", "TOP"},
                                                {"SIGNAL", "BOT"},
                                                {"COMPONENT", "comp_+_bot"},
                                                {"COMPONENT", "extra"}}));
        folder.write("steps/board/layers/extra/components", "UNITS=MM\nCMP 0 60 60 0 N X1 c\nTOP 0 59 60 0 N 0 0 1\n");
        const auto d = read(folder.path());
        QCOMPARE(d->components.size(), std::size_t{2});
        QCOMPARE(d->components[0].refdes, std::string("U1"));
        const model::SubnetId subnet = d->elements.subnet[elementOf(*d, "top", 0).row()];
        QCOMPARE(d->subnets[subnet.row()].pin, model::PinId{d->components[0].firstPin});
        QVERIFY(findDiagnostic(d->diagnostics, "another list of components on this side") != nullptr);
    }

    /// As custom pads are exported: the copper of the pin is a surface.
    void surfacesOfPinsArePads() {
        const Folder folder;
        writeParts(folder, "CMP 0 10 20 0 N U1 c\nTOP 0 9 20 0 N 0 0 1\n", "");
        const auto square = [](int x) {
            const std::string left = std::to_string(x) + " ";
            const std::string right = std::to_string(x + 2) + " ";
            return "S P 0\nOB " + left + "19 I\nOS " + right + "19\nOS " + right + "21\nOS " + left + "21\nOS " + left +
                   "19\nOE\nSE\n";
        };
        folder.write("steps/board/layers/top/features", "UNITS=MM\n" + square(8) + square(50));
        const auto d = read(folder.path());
        const model::ElementId pad = elementOf(*d, "top", 0);
        QVERIFY((d->elements.flags[pad.row()] & model::kPad) != 0);
        QVERIFY2((d->elements.flags[elementOf(*d, "top", 1).row()] & model::kPad) == 0, "that of a via subnet is none");
        QCOMPARE(model::PinFinder(*d).elementsOf(model::PinId{0}), std::vector{pad});
    }

    void groupsNameElements() {
        const Folder folder;
        writeParts(folder, "", "");
        const auto d = read(folder.path());
        QCOMPARE(d->groups.size(), std::size_t{1});
        QCOMPARE(d->text(d->groups[0].type), std::string("TEXT"));
        QCOMPARE(d->text(d->propertiesOf(d->groups[0].properties)[0].value), std::string("hello"));
        // Features 2 and 3 are one trail.
        const std::vector<model::ElementId>& grouped = d->groupElements;
        QCOMPARE(grouped, (std::vector{elementOf(*d, "top", 2), elementOf(*d, "top", 4)}));
        QVERIFY(findDiagnostic(d->diagnostics, "a group names a feature that is not there") != nullptr);
    }

    void aFeatureOfTwoNetsStaysInTheFirst() {
        const Folder folder;
        writeParts(folder, "", "");
        folder.write("steps/board/eda/data", "LYR TOP BOT\nNET A\nFID C 0 0\nNET B\nFID C 0 0\n");
        const auto d = read(folder.path());
        QCOMPARE(d->elements.net[elementOf(*d, "top", 0).row()], d->findNet("A"));
        QVERIFY(findDiagnostic(d->diagnostics, "in another net already") != nullptr);
    }

    void netlistsAreReadPointByPoint() {
        Diagnostics diagnostics;
        const auto netlist = model::odb::parseNetlist(
            "UNITS=MM\nH optimize n staggered n\n$0 $NONE$\n$1 A+B\n#\n"
            "1 0.5 10 -20 T e e staggered 0 0 0 v\n1 0 1 2 D 0.25 0.5 m c staggered 0 0 0\n0 1 1 2 B e s\n-1 1 1 2 I e "
            "s t\n"
            "1 0.0 3 4 B e c staggered 0 0 0 v\n"
            "1 x\nfoo\n$99999 far\n",
            "netlist", Unit::Inch, diagnostics);
        QCOMPARE(netlist.names, (std::vector<std::string>{"$NONE$", "A+B"}));
        QCOMPARE(netlist.points.size(), std::size_t{5});
        QCOMPARE(netlist.points[0].position, (Point{10'000'000, -20'000'000}));
        QCOMPARE(netlist.points[0].radius, 500'000);
        QVERIFY(netlist.points[0].isVia && netlist.points[0].isEnd && netlist.points[0].side == LayerSide::Top);
        QCOMPARE(netlist.points[1].width, 250'000);
        QCOMPARE(netlist.points[1].height, 500'000);
        QVERIFY(!netlist.points[1].isEnd && netlist.points[1].side == LayerSide::Bottom);
        QCOMPARE(netlist.points[1].exposure, model::Exposure::Covered);
        QCOMPARE(netlist.points[2].side, LayerSide::Through);
        QCOMPARE(netlist.points[2].exposure, model::Exposure::CoveredOnBottom);
        QCOMPARE(netlist.points[3].side, LayerSide::Inner);
        QVERIFY(netlist.points[4].isVia && netlist.points[4].width == 0 &&
                netlist.points[4].exposure == model::Exposure::Covered);
        QCOMPARE(diagnostics.entries().size(), std::size_t{3});
    }

    void aNetlistWithAnotherOriginIsMoved() {
        const Folder folder;
        writeParts(folder, "", "", "UNITS=MM\n$0 A\n$1 B\n0 1 109 -80 T e e\n1 1 150 -50 T e e\n");
        const auto d = read(folder.path());
        QCOMPARE(d->netPoints.size(), std::size_t{2});
        QCOMPARE(d->netPoints[0].position, (Point{9'000'000, 20'000'000}));
        QCOMPARE(d->netPoints[1].position, (Point{50'000'000, 50'000'000}));
        QCOMPARE(netNameOf(*d, d->netPoints[1]), std::string("B"));
        QVERIFY(findDiagnostic(d->diagnostics, "another origin") != nullptr);
    }

    /// All points lie on pads, so they count from the same origin.
    void aNetlistWithExchangedNetsIsNotMoved() {
        const Folder folder;
        writeParts(folder, "", "", "UNITS=MM\n$0 A\n$1 B\n1 1 9 20 T e e\n0 1 50 50 T e e\n");
        const auto d = read(folder.path());
        QCOMPARE(d->netPoints[0].position, (Point{9'000'000, 20'000'000}));
        QVERIFY(findDiagnostic(d->diagnostics, "another origin") == nullptr);
        QVERIFY(findDiagnostic(d->diagnostics, "2 of 2 netlist points lie on no copper of their net") != nullptr);
    }

    void onePointTellsNoOrigin() {
        const Folder folder;
        writeParts(folder, "", "", "UNITS=MM\n$0 A\n$1 B\n0 1 109 -80 T e e\n");
        const auto d = read(folder.path());
        QCOMPARE(d->netPoints[0].position, (Point{109'000'000, -80'000'000}));
        QVERIFY(findDiagnostic(d->diagnostics, "another origin") == nullptr);
        QVERIFY(findDiagnostic(d->diagnostics, "most netlist points lie on no pad") != nullptr);
    }

    void netlistsThatDisagreeAreReported() {
        const Folder folder;
        writeParts(
            folder, "", "",
            "UNITS=MM\n$0 A\n$1 B\n$2 STRANGER\n0 1 9 20 T e e\n1 1 50 50 T e e\n1 1 60 50 T e e\n2 1 1 1 T e e\n");
        const auto d = read(folder.path());
        QCOMPARE(d->netPoints.size(), std::size_t{4});
        QCOMPARE(d->text(d->netPoints[3].name), std::string("STRANGER"));
        QVERIFY(!d->netPoints[3].net.isValid());
        QVERIFY(findDiagnostic(d->diagnostics, "not on the board: STRANGER") != nullptr);
        const model::Diagnostic* beside =
            findDiagnostic(d->diagnostics, "1 of 4 netlist points lie on no copper of their net");
        QVERIFY(beside != nullptr);
        QCOMPARE(beside->line, 7U);
    }

    void aNetlistMadeFromCopperMayNumberItsNets_data() {
        QTest::addColumn<QString>("netlist");
        QTest::addColumn<QString>("names");
        QTest::addColumn<QString>("message");
        QTest::newRow("numbered") << "curcadnet"
                                  << "$0 NET0\n$1 NET1\n"
                                  << "numbers its nets (NET0, NET1, …)";
        QTest::newRow("named") << "curcadnet"
                               << "$0 A\n$1 NET1\n"
                               << "1 net of the netlist is not on the board: NET1";
        QTest::newRow("a reference") << "refnet"
                                     << "$0 NET0\n$1 NET1\n"
                                     << "2 nets of the netlist are not on the board";
    }
    void aNetlistMadeFromCopperMayNumberItsNets() {
        QFETCH(QString, netlist);
        QFETCH(QString, names);
        QFETCH(QString, message);
        const Folder folder;
        writeParts(folder, "", "");
        folder.write("steps/board/netlists/" + netlist.toStdString() + "/netlist",
                     "UNITS=MM\n" + names.toStdString() + "0 1 9 20 T e e\n1 1 50 50 T e e\n");
        QVERIFY(findDiagnostic(read(folder.path())->diagnostics, message.toStdString()) != nullptr);
    }

    void netsOfOneNameAreToldApartByTheirPlaces() {
        const Folder folder;
        writeParts(folder, "", "", "UNITS=MM\n$0 TWIN\n$1 TWIN\n1 1 9 20 T e e\n0 1 50 50 T e e\n");
        std::string eda = odb_testing::readFile(folder.path() / "steps/board/eda/data");
        eda.replace(eda.find("NET A"), 5, "NET TWIN");
        eda.replace(eda.find("NET B"), 5, "NET TWIN");
        folder.write("steps/board/eda/data", eda);
        const auto d = read(folder.path());
        QCOMPARE(d->netPoints[0].net, model::NetId{0});
        QCOMPARE(d->netPoints[1].net, model::NetId{1});
        QVERIFY(findDiagnostic(d->diagnostics, "netlist points lie on") == nullptr);
    }

    /// A point need not be in the middle of a pad: it may be anywhere on copper of its net. Copper without a net is
    /// told apart from none.
    void pointsAreLookedForOnTheCopperItself() {
        const Folder folder;
        writeParts(folder, "", "",
                   "UNITS=MM\n$0 A\n$1 B\n0 1 9 20 T e e\n1 1 50 50 T e e\n1 1 50.3 50.3 T e e\n0 1 9.45 20 T e e\n"
                   "1 1 5 5 T e e\n1 1 9 20 T e e\n0 1 9 20 B e e\n1 1 50 50 B e e\n");
        const auto d = read(folder.path());
        const model::Diagnostic* noNet =
            findDiagnostic(d->diagnostics, "1 of 8 netlist points lie on copper without a net");
        QVERIFY(noNet != nullptr);
        QCOMPARE(noNet->line, 8U);
        const model::Diagnostic* nothing = findDiagnostic(d->diagnostics, "1 of 8 netlist points lie on no copper");
        QVERIFY(nothing != nullptr);
        QCOMPARE(nothing->line, 9U);
    }
};

QTEST_APPLESS_MAIN(PartsTest)
#include "parts_test.moc"
