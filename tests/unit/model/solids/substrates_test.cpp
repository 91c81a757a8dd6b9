#include "model/solids/substrates.h"

#include <QtTest>

#include "model/board/document_builder.h"

using model::DocumentBuilder;
using model::Layer;
using model::LayerType;
using model::Nm;
using model::SubstratePart;

namespace {

using Outlines = std::vector<model::ShapeId>;

/// Four copper layers of 35 µm with 500 µm between them: z = 0, 535, 1070, 1605 µm.
class Stack {
public:
    Stack() {
        for (int i = 3; i >= 0; --i) {
            add(LayerType::Signal, static_cast<Nm>(i) * 535'000, 35'000);
        }
        m_builder.setProfile(square());
    }
    Layer& add(LayerType type, Nm z, Nm thickness) {
        Layer layer;
        layer.type = type;
        layer.z = z;
        layer.thickness = thickness;
        return m_builder.layer(m_builder.addLayer(layer));
    }
    /// A drill layer with one hole.
    void drill(Nm bottom, Nm top) {
        add(LayerType::Drill, bottom, top - bottom);
        m_builder.beginLayer(model::LayerId{m_builder.layers().size() - 1});
        DocumentBuilder::Origin origin;
        origin.flags = model::kHole;
        m_builder.addCircle({{}, 1000, 1000}, origin);
    }
    model::ShapeId square() {
        model::ShapeSketch sketch;
        const model::Point corners[] = {{0, 0}, {100, 0}, {100, 100}};
        sketch.addPolygon(corners, false);
        return m_builder.addShape(sketch);
    }
    model::ShapeId board() const { return m_builder.soFar().profile; }
    Layer& layer(std::size_t row) { return m_builder.layer(model::LayerId{row}); }
    std::vector<SubstratePart> parts() const { return model::substratesOf(m_builder.soFar()); }

private:
    DocumentBuilder m_builder;
};

std::vector<std::size_t> rows(const SubstratePart& part) {
    std::vector<std::size_t> found;
    for (const model::LayerId id : part.holes) {
        found.push_back(id.row());
    }
    return found;
}

}  // namespace

class SubstratesTest : public QObject {
    Q_OBJECT

private slots:
    void throughHolesLeaveOneSlab() {
        Stack stack;
        stack.drill(0, 1'640'000);
        stack.drill(0, 1'640'000);
        const auto parts = stack.parts();
        QCOMPARE(parts.size(), std::size_t{1});
        QCOMPARE(parts[0].bottom, 35'000);
        QCOMPARE(parts[0].top, 1'605'000);
        QCOMPARE(rows(parts[0]), (std::vector<std::size_t>{4, 5}));
    }

    void blindAndBuriedHolesCutOnlyWhatTheyPass() {
        Stack stack;
        stack.drill(0, 1'640'000);
        stack.drill(1'070'000, 1'640'000);  // blind, from the top to the second copper
        stack.drill(535'000, 1'105'000);    // buried between the inner ones
        const auto parts = stack.parts();
        QCOMPARE(parts.size(), std::size_t{4});
        QCOMPARE(rows(parts[0]), (std::vector<std::size_t>{4, 5}));
        QCOMPARE(parts[0].bottom, 1'105'000);
        QCOMPARE(rows(parts[1]), (std::vector<std::size_t>{4, 5, 6}));  // beside the second copper
        QCOMPARE(parts[1].bottom, 1'070'000);
        QCOMPARE(rows(parts[2]), (std::vector<std::size_t>{4, 6}));
        QCOMPARE(parts[2].bottom, 535'000);
        QCOMPARE(rows(parts[3]), std::vector<std::size_t>{4});
        for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
            QCOMPARE(parts[i].bottom, parts[i + 1].top);
        }
    }

    void aDielectricWithItsOwnOutlineIsASlabOfItsOwn() {
        Stack stack;
        const model::ShapeId own = stack.square();
        Layer& dielectric = stack.add(LayerType::Dielectric, 570'000, 500'000);
        dielectric.outlineGroup = 1;
        dielectric.profile = own;
        const auto parts = stack.parts();
        QCOMPARE(parts.size(), std::size_t{3});
        QVERIFY(parts[0].outlines != Outlines{own});
        QCOMPARE(parts[1].outlines, Outlines{own});
        QCOMPARE(parts[1].top, 1'105'000);  // with what lies beside the copper on both sides of it
        QCOMPARE(parts[1].bottom, 535'000);
        QVERIFY(parts[2].outlines != Outlines{own});
    }

    void whatLiesBetweenTwoLayersIsWhereBothAre() {
        Stack stack;
        const model::ShapeId rigid = stack.square();
        for (const std::size_t outer : {0U, 3U}) {
            stack.layer(outer).outlineGroup = 1;
            stack.layer(outer).profile = rigid;
        }
        const auto parts = stack.parts();
        QCOMPARE(parts.size(), std::size_t{3});
        const Outlines both{stack.board(), rigid};
        QCOMPARE(parts[0].outlines, both);
        QCOMPARE(parts[0].bottom, 1'070'000);
        QCOMPARE(parts[1].outlines, Outlines{stack.board()});
        QCOMPARE(parts[1].bottom, 570'000);
        QCOMPARE(parts[2].outlines, both);
    }

    /// A zone without the outer layers: its outermost copper lies on the substrate, on both sides.
    void nothingLiesBesideTheOutermostCopperOfAZone() {
        Stack stack;
        const model::ShapeId wide = stack.square();
        const model::ShapeId rigid = stack.square();
        const auto bound = [](Layer& layer, std::uint32_t group, model::ShapeId outline) {
            layer.outlineGroup = group;
            layer.profile = outline;
        };
        for (const std::size_t row : {0U, 3U}) {
            bound(stack.layer(row), 1, rigid);
        }
        for (const std::size_t row : {1U, 2U}) {
            bound(stack.layer(row), 2, wide);
        }
        bound(stack.add(LayerType::Dielectric, 1'105'000, 500'000), 1, rigid);
        bound(stack.add(LayerType::Dielectric, 570'000, 500'000), 2, wide);
        bound(stack.add(LayerType::Dielectric, 35'000, 500'000), 1, rigid);
        const auto parts = stack.parts();
        QCOMPARE(parts.size(), std::size_t{5});
        QCOMPARE(parts[1].outlines, (Outlines{wide, rigid}));  // beside the second copper
        QCOMPARE(parts[1].top, 1'105'000);
        QCOMPARE(parts[2].outlines, Outlines{wide});
        QCOMPARE(parts[2].top, 1'070'000);
        QCOMPARE(parts[2].bottom, 570'000);
        QCOMPARE(parts[3].outlines, (Outlines{wide, rigid}));
    }

    void everyDielectricOfARigidFlexIsASlab() {
        Stack stack;
        const model::ShapeId rigid = stack.square();
        stack.layer(0).outlineGroup = 1;  // the foil on top only, all else is alike
        stack.layer(0).profile = rigid;
        stack.add(LayerType::Dielectric, 1'405'000, 200'000);
        stack.add(LayerType::Dielectric, 1'105'000, 300'000);
        const auto parts = stack.parts();
        // Two prepregs above the second copper, then what no row of the job is.
        QCOMPARE(parts.size(), std::size_t{4});
        QCOMPARE(parts[0].bottom, 1'405'000);
        QCOMPARE(parts[1].bottom, 1'070'000);  // with what lies beside the copper below it
        QCOMPARE(parts[2].bottom, 535'000);
        QCOMPARE(parts[3].bottom, 35'000);
    }

    void dielectricsOfABoardThatIsRigidAreOneSlab() {
        Stack stack;
        stack.add(LayerType::Dielectric, 1'405'000, 200'000);
        stack.add(LayerType::Dielectric, 1'105'000, 300'000);
        QCOMPARE(stack.parts().size(), std::size_t{1});
    }

    void stepsWithoutTheOutlineHaveTheSameSlabs() {
        Stack stack;
        Layer& dielectric = stack.add(LayerType::Dielectric, 570'000, 500'000);
        dielectric.outlineGroup = 1;
        const auto parts = stack.parts();
        QCOMPARE(parts.size(), std::size_t{3});
        QCOMPARE(parts[1].outlines, parts[0].outlines);
    }

    void aBoardOfOneCopperLayerLiesOnItsLaminate() {
        DocumentBuilder builder;
        Layer copper;
        copper.type = LayerType::Signal;
        copper.thickness = 35'000;
        builder.addLayer(copper);
        builder.setBoardThickness(1'600'000);
        model::ShapeSketch sketch;
        const model::Point corners[] = {{0, 0}, {100, 0}, {100, 100}};
        sketch.addPolygon(corners, false);
        builder.setProfile(builder.addShape(sketch));
        const auto parts = model::substratesOf(builder.soFar());
        QCOMPARE(parts.size(), std::size_t{1});
        QCOMPARE(parts[0].bottom, -1'600'000);
        QCOMPARE(parts[0].top, 0);
    }
};

QTEST_APPLESS_MAIN(SubstratesTest)
#include "substrates_test.moc"
