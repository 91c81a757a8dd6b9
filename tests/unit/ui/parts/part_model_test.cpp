#include "ui/parts/part_model.h"

#include <QtTest>

#include "model/board/document_builder.h"
#include "ui/common/sorted_rows.h"
#include "ui/common/table_text.h"

using ui::BoardPart;
using ui::PartModel;

namespace {

/// U10, U2 and a test point that is not fitted and has neither package nor height.
std::shared_ptr<const model::Document> board() {
    using namespace model;
    DocumentBuilder builder;
    const NetId gnd = builder.addNet("GND");
    Package package;
    package.name = "SO8";
    package.body = builder.addShape([] {
        ShapeSketch square;
        square.addPolygon(std::array<Point, 4>{{{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}}}, false);
        return square;
    }());
    const PackageId so8 = builder.addPackage(package, {});
    const auto add = [&](const char* refdes, const char* value, Nm height, bool isFitted) {
        Component part;
        part.refdes = refdes;
        part.package = isFitted ? so8 : PackageId{};
        part.height = height;
        part.isPopulated = isFitted;
        part.placement.origin = {2'000'000, -1'000'000};
        part.side = isFitted ? LayerSide::Top : LayerSide::Bottom;
        part.properties = builder.addProperties(
            std::vector<Property>{{builder.string("Value"), builder.string(value)},
                                  {builder.string("Tolerance"), builder.string(isFitted ? "1%" : "")},
                                  {builder.string(".comp_height"), builder.string("0.1")}});
        Pin pin;
        pin.name = builder.string("1");
        pin.net = gnd;
        builder.addComponent(part, std::vector{pin});
    };
    add("U10", "100n", 1'200'000, true);
    add("U2", "20n, X7R", 800'000, true);
    add("TP1", "TestPoint", 0, false);
    return builder.finish();
}

/// R1 on a flexible inner layer, and R2 on the board.
std::shared_ptr<const model::Document> rigidFlexBoard() {
    using namespace model;
    DocumentBuilder builder;
    Layer flex;
    flex.name = "INT_1";
    flex.type = LayerType::Signal;
    const LayerId inner = builder.addLayer(flex);
    ShapeSketch sketch;
    sketch.addPolygon(std::array<Point, 4>{{{0, 0}, {1000, 0}, {1000, 1000}, {0, 1000}}}, false);
    const ShapeId shape = builder.addShape(std::move(sketch));
    for (const LayerId on : {inner, LayerId{}}) {
        Layer bodies;
        bodies.type = LayerType::ComponentBody;
        bodies.isSynthetic = true;
        bodies.spanTop = on;
        builder.beginLayer(builder.addLayer(bodies));
        Component part;
        part.refdes = on.isValid() ? "R1" : "R2";
        part.side = LayerSide::Top;
        const ComponentId component = builder.addComponent(part, {});
        builder.addBody({builder.addArea({shape, {}}, {}), component, 1'000'000});
    }
    return builder.finish();
}

}  // namespace

class PartModelTest : public QObject {
    Q_OBJECT

private slots:
    void designatorsComeAsPeopleCount() {
        PartModel model;
        model.setBoard(board());
        QCOMPARE(texts(model, PartModel::Designator), (QStringList{"TP1", "U2", "U10"}));
        QCOMPARE(model.rowOf({0, model::ComponentId{0}}), std::optional(2));
        QCOMPARE(model.partAt(0), (BoardPart{0, model::ComponentId{2}}));
        ui::SortedRows rows(model);
        rows.sort(PartModel::Designator, Qt::DescendingOrder);
        QCOMPARE(rows.index(0, 0).data().toString(), "U10");
        rows.sort(PartModel::Attributes);
        model.setAttribute("Value");
        QCOMPARE(rows.index(0, PartModel::Attributes).data().toString(), "20n, X7R");  // before 100n
    }

    void oneColumnShowsTheChosenAttributeOrAll() {
        PartModel model;
        model.setBoard(board());
        QCOMPARE(model.attributeNames(), (QStringList{".comp_height", "Tolerance", "Value"}));
        QCOMPARE(texts(model, PartModel::Attributes),
                 (QStringList{"Value: TestPoint", "Value: 20n, X7R · Tolerance: 1%", "Value: 100n · Tolerance: 1%"}));
        model.setAttribute("Tolerance");
        QCOMPARE(texts(model, PartModel::Attributes), (QStringList{"", "1%", "1%"}));
        model.setAttribute("no such attribute");
        QCOMPARE(texts(model, PartModel::Attributes).front(), "Value: TestPoint");
    }

    void aFilterLooksThroughAllAttributes() {
        PartModel model;
        model.setBoard(board());
        model.setAttribute("Tolerance");
        ui::SortedRows rows(model);
        rows.setWords("testpoint");
        QCOMPARE(rows.rowCount(), 1);
        rows.setWords("so8 n");
        QCOMPARE(rows.rowCount(), 2);
    }

    void whatTheJobDoesNotSayIsNamed() {
        PartModel model;
        QVERIFY(model.missing({}).isEmpty() && !model.hasHeights());
        model.setBoard(board());
        QCOMPARE(model.missing({0, 1, 2}), (QStringList{"1 without a height", "1 without a package outline"}));
        QCOMPARE(model.missing({1, 2}), QStringList());
        QCOMPARE(model.missing({0}), (QStringList{"no heights", "no package outlines"}));
        QVERIFY(model.hasHeights());
        QCOMPARE(model.index(0, PartModel::Height).data().toString(), "");
        QCOMPARE(model.index(1, PartModel::Height).data().toString(), "0.8000 mm");
        QCOMPARE(texts(model, PartModel::Fitted), (QStringList{"no", "yes", "yes"}));
        QCOMPARE(texts(model, PartModel::Side), (QStringList{"Bottom", "Top", "Top"}));
        model.setBoard(model::DocumentBuilder().finish());
        QCOMPARE(model.missing({}), QStringList{"The job has no components"});
        QCOMPARE(model.rowCount(), 0);
    }

    void aPartOnAnInnerLayerHasItForItsSide() {
        PartModel model;
        model.setBoard(rigidFlexBoard());
        QCOMPARE(texts(model, PartModel::Side), (QStringList{"INT_1", "Top"}));
        const auto tip = [&](int row) { return model.index(row, PartModel::Side).data(Qt::ToolTipRole).toString(); };
        QVERIFY2(tip(0).contains("the inner layer INT_1, facing the top"), qPrintable(tip(0)));
        QVERIFY(!tip(1).contains("inner"));
        ui::SortedRows rows(model);
        rows.setWords("int_1");
        QCOMPARE(rows.rowCount(), 1);
        model.setBoard(board());
        QCOMPARE(texts(model, PartModel::Side), (QStringList{"Bottom", "Top", "Top"}));
    }

    void filesNameTheUnitAndQuoteCommas() {
        PartModel model;
        model.setBoard(board());
        model.setAttribute("Value");
        model.setUnit(ui::LengthUnit::Mil);
        const QStringList lines = ui::tableCsv(model).split('\n');
        QCOMPARE(lines.size(), 5);  // a heading, three rows, and the end of the last
        QVERIFY2(lines[0].startsWith("Designator,Part,Value,Package,Side,X (mil),Y (mil),Rotation cw,Height (mil)"),
                 qPrintable(lines[0]));
        QVERIFY2(lines[2].startsWith("U2,,\"20n, X7R\",SO8,Top,78.74"), qPrintable(lines[2]));
    }

private:
    static QStringList texts(const PartModel& model, int column) {
        QStringList all;
        for (int row = 0; row < model.rowCount(); ++row) {
            all += model.index(row, column).data().toString();
        }
        return all;
    }
};

QTEST_MAIN(PartModelTest)
#include "part_model_test.moc"
