// How large bodies are and what they are made of, on packages in the sizes of real jobs (millimetres).
#include "model/packages/body_plan.h"

#include <QtTest>

#include "model/board/document_builder.h"
#include "tests/unit/model/packages/in_millimetres.h"

using model::BodyMaterial;
using model::BodyPart;
using model::BodyPlan;
using model::Box;
using model::Nm;
using model::PackageFacts;
using model::PackageFamily;
using packages::boxAt;
using packages::mm;

namespace {

PackageFacts named(const char* refdes, const char* name) {
    PackageFacts facts;
    facts.refdes = refdes;
    facts.name = name;
    facts.boardDepth = mm(1.6);
    return facts;
}

PackageFacts pair(const char* refdes, double apart, double width, double height, Box outline, bool isThrough = false) {
    PackageFacts facts = named(refdes, "");
    facts.addPin({mm(-apart / 2), 0}, boxAt(-apart / 2, 0, width, height), isThrough);
    facts.addPin({mm(apart / 2), 0}, boxAt(apart / 2, 0, width, height), isThrough);
    facts.setOutline({}, outline, {});
    return facts;
}

/// Pins on the left, then on the right, both from the top.
PackageFacts dual(double pitch, int perSide, double apart, double padLength, Box outline) {
    PackageFacts facts = named("U1", "");
    for (int i = 0; i < 2 * perSide; ++i) {
        const double x = i < perSide ? -apart / 2 : apart / 2;
        const double y = pitch * (0.5 * (perSide - 1) - i % perSide);
        facts.addPin({mm(x), mm(y)}, boxAt(x, y, padLength, 0.6 * pitch), false);
    }
    facts.setOutline({}, outline, {});
    return facts;
}

bool isNear(std::int64_t length, double millimetres, double tolerance) {
    return std::abs(static_cast<double>(length) / 1e6 - millimetres) <= tolerance;
}

Box boxOf(const BodyPart& part) {
    Box box;
    for (const model::Point p : part.polygons.points) {
        box.include(p);
    }
    return box;
}

const BodyPart* partOf(const BodyPlan& plan, BodyMaterial material) {
    const auto found = std::ranges::find(plan.parts, material, &BodyPart::material);
    return found == plan.parts.end() ? nullptr : &*found;
}

}  // namespace

class BodyPlanTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsDrawnAsTheBodyIsTheBody() {
        const Box body = boxAt(0, 0, 1.6, 0.8);
        const BodyPlan plan = planBody(pair("C1", 1.7, 0.95, 0.95, body), mm(0.5));
        QCOMPARE(plan.box, body);
        QCOMPARE(plan.height, mm(0.5));
        QVERIFY(!plan.isHeightAssumed);
        QCOMPARE(plan.material, BodyMaterial::Ceramic);
    }

    void courtyardsAreLargerThanBodies() {
        // A 0402 as KiCad writes it: 1.0 by 0.5 mm, and 1.8 by 0.9 around it.
        const BodyPlan chip = planBody(pair("R1", 1.02, 0.54, 0.64, boxAt(0, 0, 1.86, 0.94)), 0);
        QVERIFY(isNear(chip.box.width(), 1.0, 0.1));
        QVERIFY(isNear(chip.box.height(), 0.5, 0.1));
        QVERIFY(chip.isHeightAssumed);
        QVERIFY(isNear(chip.height, 0.3, 0.1));
        // A SOIC-8: 3.9 by 4.9 mm.
        const BodyPlan soic = planBody(dual(1.27, 4, 4.95, 1.95, boxAt(0, 0, 7.4, 5.4)), 0);
        QCOMPARE(soic.family, PackageFamily::DualInLine);
        QVERIFY(isNear(soic.box.width(), 3.9, 0.5));
        QVERIFY(isNear(soic.box.height(), 4.9, 0.1));
        QCOMPARE(soic.height, mm(1.75));
    }

    void whatIsDrawnBesideItsPadsIsTheBody() {
        // A can that lies over the edge of the board, its pads before it.
        const Box can = boxAt(0, 8, 6.3, 11.5);
        const BodyPlan plan = planBody(pair("C38", 2.5, 1.5, 4, can), 0);
        QCOMPARE(plan.box, can);
        QVERIFY(plan.isAsDrawn);
        QVERIFY(plan.isHeightAssumed);
        QVERIFY(isNear(plan.height, 6, 0.5));
        QCOMPARE(planBody(pair("R1", 2.5, 1.5, 4, can), 0).box, can);
    }

    void withoutAnOutlineThePinsTell() {
        const BodyPlan soic = planBody(dual(1.27, 4, 5.4, 1.55, {}), 0);
        QVERIFY(isNear(soic.box.height(), 5.08, 0.05));
        QVERIFY(soic.box.width() < mm(5.4));
        QCOMPARE(planBody(pair("R1", 1.6, 0.8, 0.95, {}), 0).box.middle(), (model::Point{0, 0}));
    }

    void turnedPackagesHaveTurnedBodies() {
        const PackageFacts along = dual(0.65, 7, 5.6, 1.7, boxAt(0, 0, 7.6, 5.5));
        const BodyPlan upright = planBody(along, mm(1.1));
        const BodyPlan turned = planBody(model::transposed(along), mm(1.1));
        QCOMPARE(turned.box, model::transposed(upright.box));
        QCOMPARE(turned.parts.size(), upright.parts.size());
        for (std::size_t i = 0; i < turned.parts.size(); ++i) {
            QCOMPARE(boxOf(turned.parts[i]), model::transposed(boxOf(upright.parts[i])));
        }
    }

    void leadsReachFromTheBodyToTheirPads() {
        const PackageFacts facts = dual(1.27, 4, 5.4, 1.55, boxAt(0, 0, 3.9, 4.9));
        const BodyPlan plan = planBody(facts, mm(1.75));
        Box metal;
        for (const BodyPart& part : plan.parts) {
            if (part.material == BodyMaterial::Metal) {
                QCOMPARE(part.polygons.polygons.size(), facts.pins.size());
                metal.include(boxOf(part));
                QVERIFY(part.bottom >= 0);
                QVERIFY(part.top <= plan.height);
            }
        }
        // Over the middles of the pads, and not beyond their ends.
        QVERIFY(metal.width() > mm(5.4) && metal.width() < mm(5.4 + 1.55));
    }

    void nothingButPinsThroughTheBoardIsBelowItsFace() {
        const BodyPlan plans[] = {planBody(pair("C1", 1.7, 0.95, 0.95, {}), 0), planBody(dual(0.5, 8, 2.8, 0.7, {}), 0),
                                  planBody(dual(1.27, 4, 5.4, 1.55, {}), 0)};
        for (const BodyPlan& plan : plans) {
            QVERIFY(!plan.parts.empty());
            for (const BodyPart& part : plan.parts) {
                QVERIFY(part.bottom >= 0);
                QVERIFY(part.top > part.bottom);
            }
        }
        const PackageFacts header = pair("J1", 2.54, 1.7, 1.7, boxAt(0, 0, 5.1, 2.6), true);
        const BodyPlan plan = planBody(header, mm(8.5));
        QCOMPARE(plan.family, PackageFamily::Header);
        const BodyPart* pins = partOf(plan, BodyMaterial::Gold);
        QVERIFY(pins != nullptr);
        QVERIFY(pins->bottom < -header.boardDepth);
        QCOMPARE(pins->top, mm(8.5));
        QCOMPARE(plan.height, mm(8.5));
        QVERIFY(plan.bodyTop < mm(3));
    }

    void housingsOfConnectorsEndOverTheirPads() {
        // Signal pins above, two mounting pads below, as KiCad draws a JST SH of 4 pins: the housing is 6 by 4.3 mm.
        PackageFacts facts = named("J1", "JST_SH_SM04B");
        for (int i = 0; i < 4; ++i) {
            facts.addPin({mm(i - 1.5), mm(2)}, boxAt(i - 1.5, 2, 0.6, 1.55), false);
        }
        for (const double x : {-2.8, 2.8}) {
            facts.addPin({mm(x), mm(-1.88)}, boxAt(x, -1.88, 1.2, 1.8), false);
        }
        facts.setOutline({}, boxAt(0, 0, 7.79, 6.55), {});
        const BodyPlan plan = planBody(facts, 0);
        QCOMPARE(plan.family, PackageFamily::Connector);
        QVERIFY(isNear(plan.box.height(), 4.1, 0.3));
        QVERIFY(isNear(plan.box.width(), 6.4, 0.5));
        QCOMPARE(plan.material, BodyMaterial::Housing);
        QVERIFY(partOf(plan, BodyMaterial::Print) == nullptr);
        QVERIFY(partOf(plan, BodyMaterial::DarkPrint) != nullptr);
    }

    void bodiesLieOverTheTabsOfPowerPackages() {
        // A DDPAK: five leads at the bottom, a tab of 10 by 8 mm above.
        PackageFacts facts = named("U39", "5-DDPAK");
        for (int i = 0; i < 5; ++i) {
            facts.addPin({mm(1.7 * (i - 2)), mm(-5.8)}, boxAt(1.7 * (i - 2), -5.8, 1.1, 2.7), false);
        }
        facts.addPin({0, mm(3)}, boxAt(0, 3, 10.6, 8.5), false);
        facts.setOutline({}, boxAt(0, 0, 10.2, 14), {});
        const BodyPlan plan = planBody(facts, 0);
        QCOMPARE(plan.family, PackageFamily::SmallOutline);
        QVERIFY(plan.box.height() > mm(6.5));
        QCOMPARE(plan.box.max.y, mm(3));
    }

    void theMarkIsNextToPinOne() {
        PackageFacts facts = dual(1.27, 4, 5.4, 1.55, boxAt(0, 0, 3.9, 4.9));
        for (const std::size_t first : {std::size_t{0}, std::size_t{5}}) {
            facts.firstPin = first;
            const BodyPlan plan = planBody(facts, 0);
            const BodyPart* mark = partOf(plan, BodyMaterial::Print);
            QVERIFY(mark != nullptr);
            const model::Point middle = boxOf(*mark).middle();
            QCOMPARE(middle.x < 0, facts.pins[first].position.x < 0);
            QCOMPARE(middle.y < 0, facts.pins[first].position.y < 0);
            QVERIFY(plan.box.holds(boxOf(*mark).min) && plan.box.holds(boxOf(*mark).max));
            QCOMPARE(mark->bottom, plan.height);
        }
    }

    void heightsThatCannotBeAreNotBelieved() {
        const PackageFacts facts = pair("C1", 1.7, 0.95, 0.95, {});
        for (const Nm height : {-mm(1), Nm{0}, Nm{25'000}, mm(900)}) {
            const BodyPlan plan = planBody(facts, height);
            QVERIFY(plan.isHeightAssumed);
            QVERIFY(plan.height > mm(0.2) && plan.height < mm(2));
        }
    }

    void nothingIsMadeOfNothing() {
        QVERIFY(model::planBody({}, mm(1)).box.isEmpty());
        PackageFacts dots = named("R1", "");
        dots.addPin({0, 0}, {}, false);
        dots.addPin({0, 0}, {}, false);
        const BodyPlan plan = planBody(dots, 0);
        QVERIFY(plan.box.isEmpty());
        QVERIFY(plan.parts.empty());
    }

    void chipsOfEveryKindHaveTheirColour() {
        const Box outline = boxAt(0, 0, 1.6, 0.8);
        const auto materialOf = [&](const char* refdes) {
            return planBody(pair(refdes, 1.7, 0.95, 0.95, outline), 0).material;
        };
        QCOMPARE(materialOf("R1"), BodyMaterial::Resistor);
        QCOMPARE(materialOf("C1"), BodyMaterial::Ceramic);
        QCOMPARE(materialOf("L1"), BodyMaterial::Ferrite);
        QCOMPARE(materialOf("LED1"), BodyMaterial::Lens);
        QCOMPARE(materialOf("D1"), BodyMaterial::Moulding);
        QVERIFY(partOf(planBody(pair("R1", 1.7, 0.95, 0.95, outline), 0), BodyMaterial::Metal) != nullptr);
    }

    /// Both are connectors by their names.
    void jumpersAreBareWhateverElseHasTheirPackage() {
        for (const bool isJumperFirst : {true, false}) {
            model::DocumentBuilder builder;
            std::array<model::PackagePin, 2> pins;
            pins[0].position = {mm(-0.65), 0};
            pins[1].position = {mm(0.65), 0};
            const model::PackageId package = builder.addPackage({}, pins);
            const auto add = [&](const char* refdes) {
                model::Component component;
                component.refdes = refdes;
                component.package = package;
                return builder.addComponent(component, {});
            };
            const model::ComponentId first = add(isJumperFirst ? "JP1" : "J1");
            const model::ComponentId second = add(isJumperFirst ? "J1" : "JP1");
            const auto document = builder.finish();
            model::BodyPlans plans(*document);
            QCOMPARE(plans.of(first).family, isJumperFirst ? PackageFamily::None : PackageFamily::Connector);
            QCOMPARE(plans.of(second).family, isJumperFirst ? PackageFamily::Connector : PackageFamily::None);
        }
    }
};

QTEST_APPLESS_MAIN(BodyPlanTest)
#include "body_plan_test.moc"
