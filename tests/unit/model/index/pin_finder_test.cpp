#include "model/index/pin_finder.h"

#include <QtTest>

#include "model/board/document_builder.h"
#include "model/formats/registry.h"
#include "tests/locations.h"

using namespace model;

namespace {

constexpr Nm kMm = 1'000'000;

/// U1 with pins 1 (net A, at 0 mm) and 2 (net B, at 2 mm), and a body; U2 and U3 with one pin on net A at 5 and 20 mm.
struct Board {
    Board() {
        DocumentBuilder builder;
        const NetId a = builder.addNet("A");
        const NetId b = builder.addNet("B");
        std::vector<Pin> pins(2);
        pins[0] = {builder.string("1"), {0, 0}, a, {}};
        pins[1] = {builder.string("2"), {2 * kMm, 0}, b, {}};
        Component part;
        part.refdes = "U1";
        u1 = builder.addComponent(part, pins);
        part.refdes = "U2";
        u2 = builder.addComponent(part, std::vector<Pin>{{builder.string("1"), {5 * kMm, 0}, a, {}}});
        part.refdes = "U3";
        u3 = builder.addComponent(part, std::vector<Pin>{{builder.string("1"), {20 * kMm, 0}, a, {}}});
        Subnet named;
        named.net = a;
        named.kind = SubnetKind::PinPads;
        named.pin = PinId{std::size_t{2}};
        const SubnetId toeprint = builder.addSubnet(named);
        builder.beginLayer(builder.addLayer({}));
        const auto circle = [&](Nm x, NetId net, std::uint8_t flags, SubnetId subnet = {}) {
            DocumentBuilder::Origin origin;
            origin.net = net;
            origin.flags = flags;
            origin.subnet = subnet;
            return builder.addCircle({{x, 0}, kMm, 0}, origin);
        };
        padA = circle(0, a, kPad);
        holeA = circle(0, a, kHole | kPlated);
        trackA = circle(0, a, 0);
        padB = circle(2 * kMm, b, kPad);
        elsewhere = circle(9 * kMm, a, kPad);
        named5 = circle(9 * kMm, a, kPad, toeprint);   // the job says so, wherever it lies
        shared = circle(20 * kMm, a, kPad, toeprint);  // U3 has a pin there too
        noNet = circle(0, {}, kPad);
        body = circle(kMm, {}, 0);
        builder.addBody({body, u1, kMm, Source::Job});
        document = builder.finish();
    }
    std::shared_ptr<const Document> document;
    ComponentId u1, u2, u3;
    ElementId padA, holeA, trackA, padB, elsewhere, named5, shared, noNet, body;
};

}  // namespace

class PinFinderTest : public QObject {
    Q_OBJECT

private slots:
    void padsBelongToTheirPins() {
        const Board board;
        const PinFinder finder(*board.document);
        const auto pin = [](std::size_t row) { return std::vector{PinId{row}}; };
        QCOMPARE(finder.pinsOf(board.padA), pin(0));
        QCOMPARE(finder.pinsOf(board.holeA), pin(0));
        QCOMPARE(finder.pinsOf(board.padB), pin(1));
        QCOMPARE(finder.pinsOf(board.named5), pin(2));
        for (const ElementId none : {board.trackA, board.elsewhere, board.noNet, board.body}) {
            QVERIFY(finder.pinsOf(none).empty());
        }
    }

    void componentsAreTheirPadsHolesAndBody() {
        const Board board;
        const PinFinder finder(*board.document);
        QCOMPARE(finder.elementsOf(board.u1), (std::vector{board.padA, board.holeA, board.padB, board.body}));
        QCOMPARE(finder.elementsOf(board.u2), (std::vector{board.named5, board.shared}));
        QCOMPARE(finder.elementsOf(board.u3), std::vector{board.shared});
        QCOMPARE(finder.elementsOf(PinId{std::size_t{0}}), (std::vector{board.padA, board.holeA}));
        for (const ElementId element : finder.elementsOf(board.u1)) {
            QCOMPARE(finder.componentOf(element), board.u1);
        }
        QVERIFY(!finder.componentOf(board.trackA).isValid());
    }

    /// An exposed pad with a via in its middle: the job says which pad is the pin's.
    void padsOfViasTracksAndPlanesAreNoPinsOfWhatLiesThere() {
        for (const SubnetKind kind : {SubnetKind::Via, SubnetKind::Trace, SubnetKind::Plane, SubnetKind::Other}) {
            DocumentBuilder builder;
            Pin pin;
            pin.net = builder.addNet("GND");
            builder.addComponent({}, std::vector{pin});
            Subnet subnet;
            subnet.net = pin.net;
            subnet.kind = kind;
            DocumentBuilder::Origin other;
            other.net = pin.net;
            other.subnet = builder.addSubnet(subnet);
            other.flags = kPad;
            subnet.kind = SubnetKind::PinPads;
            subnet.pin = PinId{std::size_t{0}};
            DocumentBuilder::Origin own = other;
            own.subnet = builder.addSubnet(subnet);
            builder.beginLayer(builder.addLayer({}));
            const ElementId exposed = builder.addCircle({{0, 0}, 4 * kMm, 0}, own);
            const ElementId pad = builder.addCircle({{0, 0}, kMm, 0}, other);
            other.flags = kHole | kPlated;
            const ElementId hole = builder.addCircle({{0, 0}, kMm / 2, 0}, other);
            const auto document = builder.finish();
            const auto found = PinFinder(*document).elementsOf(PinId{std::size_t{0}});
            const std::vector<ElementId> all{exposed, pad, hole};
            QCOMPARE(found, kind == SubnetKind::Other ? all : std::vector{exposed});
        }
    }

    /// The second of two parts on the same pads, and a via between them.
    void sharedPadsAreNotThoseOfVias() {
        DocumentBuilder builder;
        Pin pin;
        pin.net = builder.addNet("A");
        builder.addComponent({}, std::vector{pin, pin});
        Subnet subnet;
        subnet.net = pin.net;
        subnet.kind = SubnetKind::Via;
        DocumentBuilder::Origin via;
        via.net = pin.net;
        via.flags = kPad;
        via.subnet = builder.addSubnet(subnet);
        subnet.kind = SubnetKind::PinPads;
        subnet.pin = PinId{std::size_t{0}};
        DocumentBuilder::Origin pad = via;
        pad.subnet = builder.addSubnet(subnet);
        builder.beginLayer(builder.addLayer({}));
        const ElementId shared = builder.addCircle({{0, 0}, 4 * kMm, 0}, pad);
        builder.addCircle({{0, 0}, kMm, 0}, via);
        const auto document = builder.finish();
        QCOMPARE(PinFinder(*document).elementsOf(PinId{std::size_t{1}}), std::vector{shared});
    }

    /// Two pads of one net above each other, and a pin of a component on the lower side.
    void padsOnTheFarSideAreNoPinsOfSurfaceMountComponents() {
        for (const MountType mount : {MountType::Surface, MountType::Unknown}) {
            DocumentBuilder builder;
            const NetId gnd = builder.addNet("GND");
            Component part;
            part.side = LayerSide::Bottom;
            part.mount = mount;
            Pin pin;
            pin.net = gnd;
            pin.packagePin = 0;
            const std::vector<PackagePin> packagePins(1);
            part.package = builder.addPackage({}, packagePins);
            builder.addComponent(part, std::vector{pin});
            std::vector<ElementId> pads;
            for (const LayerSide side : {LayerSide::Top, LayerSide::Bottom}) {
                Layer layer;
                layer.side = side;
                layer.type = LayerType::Signal;
                builder.beginLayer(builder.addLayer(layer));
                DocumentBuilder::Origin origin;
                origin.net = gnd;
                origin.flags = kPad;
                pads.push_back(builder.addCircle({{0, 0}, kMm, 0}, origin));
            }
            const auto document = builder.finish();
            const auto found = PinFinder(*document).elementsOf(PinId{std::size_t{0}});
            QCOMPARE(found, mount == MountType::Surface ? std::vector{pads[1]} : pads);
        }
    }

    void bothWaysAgreeOnARealBoard() {
        base::Progress progress;
        const auto board = readBoard(locations::kSample, {}, progress);
        QVERIFY(board.ok());
        const Document& document = **board;
        const PinFinder finder(document);
        std::size_t pads = 0;
        for (std::size_t row = 0; row < document.elements.size(); ++row) {
            for (const PinId pin : finder.pinsOf(ElementId{row})) {
                const auto back = finder.elementsOf(pin);
                QVERIFY(std::ranges::binary_search(back, ElementId{row}));
                ++pads;
            }
        }
        QVERIFY(pads > 50);
        for (std::size_t row = 0; row < document.components.size(); ++row) {
            for (const ElementId element : finder.elementsOf(ComponentId{row})) {
                const auto pins = finder.pinsOf(element);  // of other parts too, where those share a pad
                const auto isOwn = [&](PinId pin) { return document.pins[pin.row()].component == ComponentId{row}; };
                QVERIFY(std::ranges::any_of(pins, isOwn) || finder.componentOf(element) == ComponentId{row});
            }
        }
    }
};

QTEST_APPLESS_MAIN(PinFinderTest)
#include "pin_finder_test.moc"
