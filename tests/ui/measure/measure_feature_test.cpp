// Measuring with mouse and keys in both views, and what becomes of the measurements.
#include "ui/measure/measure_feature.h"

#include <QClipboard>
#include <QFileDialog>
#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QStatusBar>
#include <QtTest>
#include <cmath>

#include "model/measure/separation.h"
#include "tests/locations.h"
#include "tests/patience.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/table_view.h"

using model::Measurement;
using model::MeasurementKind;
using ui::ActionId;
using ui::BoardView;
using ui::MeasureFeature;
namespace fs = std::filesystem;

class MeasureFeatureTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_fixture = std::make_unique<WindowFixture>();
        m_job = m_fixture->copyOfSample().toStdString();
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(m_job.string())));
        window().showPanel("measurements");
        findPads();
        // Both pads in the middle, the copper of their layer alone.
        window().layers().showOnly({board().layer(board().elements.layer[m_a.row()]).name});
        for (BoardView* view : window().views().both()) {
            view->controller().look(render::NamedView::Top);
        }
        model::Box both = board().boxOf(m_a);
        both.include(board().boxOf(m_b));
        const ui::BoardPosition location = window().probing().position();
        flat().controller().show(location.toModel(base::toDouble(both.min)),
                                 location.toModel(base::toDouble(both.max)));
        solid().controller().show(location.toModel(base::toDouble(both.min), 1.6e6),
                                  location.toModel(base::toDouble(both.max), 1.6e6));
    }
    void cleanup() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void twoClicksMeasureFromCentreToCentreInBothViews() {
        for (BoardView* view : window().views().both()) {
            const QImage before = picture(*view);
            m_fixture->key(Qt::Key_M);
            QVERIFY(window().actions()[ActionId::MeasurePoints].isChecked());
            click(*view, screenOf(*view, m_a) + QPointF(3, 2));
            move(*view, screenOf(*view, m_b));
            QTRY_VERIFY(window().label("position").contains("Δ"));
            click(*view, screenOf(*view, m_b) + QPointF(-2, 3));
            QVERIFY(!window().label("position").contains("Δ"));
            const Measurement& m = list().back();
            QVERIFY2(std::abs(m.distance() - centreDistance()) < 1e-3,
                     qPrintable(QString("%1, not %2").arg(m.distance()).arg(centreDistance())));
            QCOMPARE(m.from.snap, std::string("centre"));
            QCOMPARE(m.from.net, netOf(m_a));
            QCOMPARE(m.to.net, netOf(m_b));
            QVERIFY(window().selection().selected().empty());  // clicks measured, nothing else
            m_fixture->key(Qt::Key_M);
            QCOMPARE(window().measuring().tool(), MeasureFeature::Tool::None);
            QVERIFY(differingPixels(before, picture(*view)) > 200);
        }
        QCOMPARE(list().size(), std::size_t{2});
    }

    void theStatusBarSaysWhatAClickWouldMeasure() {
        m_fixture->key(Qt::Key_M);
        click(flat(), screenOf(flat(), m_a) + QPointF(3, 2));
        move(flat(), screenOf(flat(), m_b) + QPointF(-2, 3));
        const QString said = window().label("position").section("Δ", 1).trimmed();
        click(flat(), screenOf(flat(), m_b) + QPointF(-2, 3));
        const Measurement& m = list().back();
        const QString measured = ui::positionText(m.dx(), m.dy(), ui::LengthUnit::Millimetre) + "   " +
                                 ui::lengthText(m.distance(), ui::LengthUnit::Millimetre);
        QCOMPARE(said, measured);
    }

    void heldKeysLockDirectionsAndLetGo() {
        m_fixture->key(Qt::Key_M);
        const auto measure = [&](Qt::KeyboardModifiers modifiers, QPointF offset) {
            click(flat(), screenOf(flat(), m_a));
            click(flat(), screenOf(flat(), m_b) + offset, modifiers);
            return list().back();
        };
        const Measurement straight = measure(Qt::ShiftModifier, {});
        QVERIFY(std::abs(straight.dx()) < 1e-3 || std::abs(straight.dy()) < 1e-3);
        QVERIFY(straight.distance() > 1000);
        const Measurement slanting = measure(Qt::ControlModifier, {});
        const double ratio = std::abs(slanting.dx()) - std::abs(slanting.dy());
        QVERIFY(std::abs(ratio) < 1e-2 || std::abs(slanting.dx()) < 1e-3 || std::abs(slanting.dy()) < 1e-3);
        const Measurement free = measure(Qt::AltModifier, {2, 1});
        QCOMPARE(free.to.snap, std::string("free"));
        QVERIFY(std::abs(free.distance() - centreDistance()) > 10);
    }

    void twoElementsAreMeasuredFromEdgeToEdge() {
        m_fixture->key(Qt::Key_M, Qt::ShiftModifier);
        click(flat(), screenOf(flat(), m_a));
        click(flat(), screenOf(flat(), m_b));
        base::Progress progress;
        const auto index = *model::indexBoard(std::make_shared<const model::Document>(board()), progress);
        const auto expected =
            *model::separationOf(*index, model::BoardElement{0, m_a}, model::BoardElement{0, m_b}, progress);
        QCOMPARE(list().size(), std::size_t{1});
        QCOMPARE(list()[0].kind, MeasurementKind::Clearance);
        QVERIFY(std::abs(list()[0].distance() - expected.main()->distance) < 1e-3);
        click(flat(), screenOf(flat(), m_a));
        click(flat(), screenOf(flat(), m_a));  // the same twice: said, not measured
        QCOMPARE(list().size(), std::size_t{1});
        QVERIFY(window().statusBar()->currentMessage().contains("both are the same"));
    }

    void theBoardsEdgeIsMeasuredTo() {
        const auto index = window().workspace().board()->index;
        base::Progress progress;
        const auto expected =
            *model::separationOf(*index, model::BoardElement{0, m_a}, model::MeasureItem(model::BoardEdge{}), progress);
        const base::PointD on = expected.main()->spacing.to;
        const ui::BoardPosition location = window().probing().position();
        model::Box both = board().boxOf(m_a);
        both.include(base::Point{static_cast<model::Nm>(on.x), static_cast<model::Nm>(on.y)});
        flat().controller().show(location.toModel(base::toDouble(both.min)),
                                 location.toModel(base::toDouble(both.max)));
        m_fixture->key(Qt::Key_M, Qt::ShiftModifier);
        click(flat(), screenOf(flat(), m_a));
        click(flat(), *flat().controller().screenOf(location.toModel(on, 0.0)));
        QCOMPARE(list().size(), std::size_t{1});
        QVERIFY(std::abs(list()[0].value() - expected.main()->distance) < 1e-3);
        QCOMPARE(list()[0].to.item, std::string("board's edge"));
        QVERIFY(table().model()->index(0, ui::MeasurementModel::Nets).data().toString().endsWith("board's edge"));
    }

    /// To people a pad and the hole in it are one thing.
    void padsAreCaughtBeforeTheHolesInThem() {
        model::ElementId pad;
        for (const model::ElementId id : m_roundPads) {
            const bool isDrilled = std::ranges::any_of(board().layers, [&](const model::Layer& layer) {
                return layer.type == model::LayerType::Drill && holeIn(layer, id);
            });
            pad = isDrilled ? id : pad;
        }
        QVERIFY(pad.isValid());
        window().actions()[ActionId::ShowAllLayers].trigger();
        const model::Box box = board().boxOf(pad);
        const ui::BoardPosition location = window().probing().position();
        flat().controller().show(location.toModel(base::toDouble(box.min)), location.toModel(base::toDouble(box.max)));
        m_fixture->key(Qt::Key_M, Qt::ShiftModifier);
        click(flat(), screenOf(flat(), pad));
        QCOMPARE(window().selection().marked(), std::vector<model::BoardElement>({{0, pad}}));
        m_fixture->key(Qt::Key_Escape);
        click(flat(), screenOf(flat(), pad), Qt::AltModifier);
        QCOMPARE(window().selection().marked().size(), std::size_t{1});
        QVERIFY(board().elements.flags[window().selection().marked().front().element.row()] & model::kHole);
    }

    void aClearanceNamesItsElementsAndSaysWhereTheirNetsAreNearer() {
        m_fixture->key(Qt::Key_M, Qt::ShiftModifier);
        click(flat(), screenOf(flat(), m_a));
        click(flat(), screenOf(flat(), m_b));
        const auto index = window().workspace().board()->index;
        const auto nameOf = [&](model::ElementId id) {
            return QString::fromStdString(model::kindOf(*index, {0, id}) + " of " + netOf(id));
        };
        QVERIFY2(nameOf(m_a).startsWith("pad "), qPrintable(nameOf(m_a)));
        const QString said = table().model()->index(0, ui::MeasurementModel::Nets).data().toString();
        QCOMPARE(said, nameOf(m_a) + " – " + nameOf(m_b));
        base::Progress progress;
        const auto netAt = [&](model::ElementId id) { return model::NetOfCopy{0, board().elements.net[id.row()]}; };
        const auto nets = *model::separationOf(*index, netAt(m_a), netAt(m_b), progress);
        QVERIFY2(nets.onLayer->distance < list()[0].distance() - 1.0, "the pads are the nearest of their nets");
        const QString nearer = ui::fixedLengthInBoth(nets.onLayer->distance, ui::LengthUnit::Millimetre);
        const QString details = table().model()->index(0, ui::MeasurementModel::Details).data().toString();
        QVERIFY2(details.contains("their nets come as near as " + nearer + " elsewhere, on "), qPrintable(details));
    }

    void labelsKeepOffTheViewCubeAndTheLegendOfTheMap() {
        window().resize(1'500, 950);
        window().actions()[ActionId::ShowSolid].trigger();
        window().actions()[ActionId::ClearanceMap].trigger();
        QTRY_COMPARE(solid().corners().size(), std::size_t{2});
        QVERIFY(solid().corners()[0] == window().viewCube().place() ||
                solid().corners()[1] == window().viewCube().place());
        const QSizeF canvas = solid().controller().viewport();
        QImage image(canvas.toSize(), QImage::Format_ARGB32_Premultiplied);
        for (const QRectF& corner : solid().corners()) {
            QPainter painter(&image);
            ui::MeasurementPainter on(painter, solid(), board());
            Measurement measurement;
            const auto [from, along] = solid().controller().rayAt(corner.center());
            const float top = solid().position().toModel({0.0, 0.0}, board().boardThickness).z;
            const base::PointD at = solid().position().toJob(from + along * ((top - from.z) / along.z));
            measurement.from.x = measurement.to.x = at.x;
            measurement.from.y = measurement.to.y = at.y;
            on.paint(measurement, ui::LengthUnit::Millimetre, true);
            const std::vector<QRectF> labels = on.paintLabels();
            QCOMPARE(labels.size(), std::size_t{1});
            for (const QRectF& other : solid().corners()) {
                QVERIFY(!labels[0].intersects(other));
            }
        }
        window().actions()[ActionId::ClearanceMap].trigger();
    }

    void theFirstOfTwoElementsIsMarkedAndTheValueIsLive() {
        m_fixture->key(Qt::Key_M, Qt::ShiftModifier);
        click(flat(), screenOf(flat(), m_a));
        QCOMPARE(window().selection().marked(), (std::vector<model::BoardElement>{{0, m_a}}));
        const QImage before = picture(flat());
        move(flat(), screenOf(flat(), m_b));
        QVERIFY(differingPixels(before, picture(flat())) > 100);
        QVERIFY(list().empty());
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(window().selection().marked().empty());
        click(flat(), screenOf(flat(), m_a));
        click(flat(), screenOf(flat(), m_b));
        QVERIFY(window().selection().marked().empty());
        QCOMPARE(list().size(), std::size_t{1});
    }

    void theMenuOfTheListShowsRenamesAndUndoes() {
        measureBoth();
        QStringList texts;
        for (const QAction* action : table().actions()) {
            texts += action->text().remove('&').section(' ', 0, 0);
        }
        for (const char* text : {"Show", "Rename", "Delete", "Undo"}) {
            QVERIFY2(texts.contains(text), qPrintable(texts.join(' ')));
        }
        table().setCurrentIndex(table().model()->index(0, 1));
        action("Rename")->trigger();
        QVERIFY(table().findChild<QLineEdit*>() != nullptr);
        QTest::keyClick(table().findChild<QLineEdit*>(), Qt::Key_Escape);
        flat().controller().fit();
        const float before = flat().controller().mmPerPixel();
        action("Show")->trigger();
        QVERIFY(flat().controller().mmPerPixel() < before);
    }

    void oneKeyMeasuresTheGapAtTheCursor() {
        m_fixture->key(Qt::Key_R);
        QVERIFY(list().empty());  // the cursor is on no view
        move(flat(), screenOf(flat(), m_a));
        m_fixture->key(Qt::Key_R);
        QCOMPARE(list().size(), std::size_t{1});
        QVERIFY(list()[0].kind == MeasurementKind::Spacing && list()[0].distance() > 0);
        QCOMPARE(list()[0].from.layer, list()[0].to.layer);
        QVERIFY(list()[0].from.net != list()[0].to.net);
        m_fixture->key(Qt::Key_R);
        QCOMPARE(list().size(), std::size_t{1});
        QVERIFY(window().statusBar()->currentMessage().startsWith("Measured already"));
        window().actions()[ActionId::DeleteMeasurements].trigger();
        QCOMPARE(window().statusBar()->currentMessage(), QStringLiteral("1 measurement deleted"));
    }

    /// A via has a pad on every layer: that of the layer on top is what is seen and meant.
    void theGapIsOnTheLayerOfThePadAtTheCursor() {
        const std::string top = board().layer(board().elements.layer[m_a.row()]).name;
        window().actions()[ActionId::ShowAllLayers].trigger();
        const ui::BoardPosition location = window().probing().position();
        QVERIFY(m_roundPads.size() >= 10);
        for (std::size_t i = 0; i < 10; ++i) {
            const model::Box box = board().boxOf(m_roundPads[i]);
            flat().controller().show(location.toModel(base::toDouble(box.min)),
                                     location.toModel(base::toDouble(box.max)));
            move(flat(), screenOf(flat(), m_roundPads[i]));
            m_fixture->key(Qt::Key_R);
            QVERIFY(!list().empty());  // two pads may have the same spacing, which is kept once
            QCOMPARE(list().back().from.layer, top);
        }
    }

    void escapeGoesBackStepByStep() {
        window().selection().select({{0, m_a}});
        m_fixture->key(Qt::Key_M);
        click(flat(), screenOf(flat(), m_a));
        m_fixture->key(Qt::Key_Escape);
        QCOMPARE(window().measuring().tool(), MeasureFeature::Tool::Points);
        click(flat(), screenOf(flat(), m_b));
        QVERIFY(list().empty());  // it was a first point again
        m_fixture->key(Qt::Key_Escape);
        m_fixture->key(Qt::Key_Escape);
        QCOMPARE(window().measuring().tool(), MeasureFeature::Tool::None);
        QVERIFY(!window().selection().selected().empty());
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(window().selection().selected().empty());
        click(flat(), screenOf(flat(), m_a));  // clicks select again
        QVERIFY(!window().selection().selected().empty());
    }

    void measurementsAreRenamedHiddenForgottenAndUndone() {
        const QImage before = picture(flat());
        measureBoth();
        m_fixture->key(Qt::Key_Escape);
        const QImage shown = picture(flat());
        QVERIFY(differingPixels(before, shown) > 200);
        table().setCurrentIndex(table().model()->index(0, 0));
        QVERIFY(table().model()->setData(table().model()->index(0, 0), Qt::Unchecked, Qt::CheckStateRole));
        QCOMPARE(differingPixels(before, picture(flat())), 0);
        undo();
        QVERIFY(list()[0].isShown);
        table().setFocus();
        table().setCurrentIndex(table().model()->index(0, 0));
        QTest::keyClick(&table(), Qt::Key_F2);
        auto* editor = table().findChild<QLineEdit*>();
        QVERIFY(editor != nullptr);
        editor->selectAll();
        QTest::keyClicks(editor, "pad to pad");
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_COMPARE(list()[0].name, std::string("pad to pad"));
        QTRY_VERIFY(table().findChild<QLineEdit*>() == nullptr);
        table().selectRow(0);
        table().setFocus();
        QTest::keyClick(&table(), Qt::Key_Delete);
        QVERIFY(list().empty());
        undo();
        QCOMPARE(list()[0].name, std::string("pad to pad"));
    }

    void allAreHiddenShownAgainAndDeletedAtOnce() {
        const QImage before = picture(flat());
        measureBoth();
        m_fixture->key(Qt::Key_Escape);
        const QImage shown = picture(flat());
        QAction& showing = window().actions()[ActionId::ShowMeasurements];
        QVERIFY(showing.isChecked());
        showing.trigger();
        QCOMPARE(differingPixels(before, picture(flat())), 0);
        showing.trigger();
        QCOMPARE(differingPixels(shown, picture(flat())), 0);
        window().actions()[ActionId::DeleteMeasurements].trigger();
        QVERIFY(list().empty());
        QCOMPARE(differingPixels(before, picture(flat())), 0);
        undo();
        QCOMPARE(list().size(), std::size_t{1});
        window().actions()[ActionId::Redo].trigger();
        showing.trigger();
        measureBoth();
        QVERIFY2(showing.isChecked(), "who measures wants to see it");
    }

    void anEmptyListIsNotExported() {
        window().actions()[ActionId::ExportMeasurements].trigger();
        QCOMPARE(window().statusBar()->currentMessage(), QStringLiteral("There are no measurements to export"));
        QVERIFY(window().findChild<QFileDialog*>() == nullptr);
    }

    void measurementsAreInTheSessionAndInATable() {
        measureBoth();
        const std::vector<Measurement> kept = list();
        const QString path = m_fixture->folder() + "/out.csv";
        window().save(ui::ActionId::ExportMeasurements, path);
        QFile csv(path);
        QVERIFY(csv.open(QIODevice::ReadOnly));
        QCOMPARE(csv.readAll().count('\n'), 2);
        m_fixture->restart();
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(m_job.string())));
        QVERIFY(list() == kept);
    }

    void aDoubleClickBringsAMeasurementToTheMiddle() {
        measureBoth();
        flat().controller().fit();
        solid().controller().fit();
        const float before[] = {flat().controller().mmPerPixel(), solid().controller().mmPerPixel()};
        const QPoint cell = table().visualRect(table().model()->index(0, 1)).center();
        QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, cell);
        QTest::mouseDClick(table().viewport(), Qt::LeftButton, {}, cell);
        QVERIFY(flat().controller().mmPerPixel() < before[0]);
        QVERIFY(solid().controller().mmPerPixel() < before[1]);
    }

    void copiedRowsAreText() {
        measureBoth();
        table().selectRow(0);
        table().copySelection();
        QVERIFY(QGuiApplication::clipboard()->text().contains("mil"));
    }

private:
    TestWindow& window() { return m_fixture->window(); }
    BoardView& flat() { return window().views().flat(); }
    BoardView& solid() { return window().views().solid(); }
    const model::Document& board() { return *window().document(); }
    const std::vector<Measurement>& list() { return window().measurements().measurements(); }
    QAction* action(const QString& text) {
        for (QAction* action : table().actions()) {
            if (action->text() == text) {
                return action;
            }
        }
        return nullptr;
    }
    ui::TableView& table() { return window().table("measurements"); }
    void undo() { window().actions()[ActionId::Undo].trigger(); }

    /// Two round pads of different nets on the uppermost copper layer, the nearest to each other.
    void findPads() {
        m_roundPads.clear();
        const auto& elements = board().elements;
        for (std::size_t row = 0; row < elements.size(); ++row) {
            const model::Layer& layer = board().layer(elements.layer[row]);
            if (layer.isCopper() && layer.side == model::LayerSide::Top && (elements.flags[row] & model::kPad) != 0 &&
                elements.kind[row] == model::ElementKind::Circle && elements.net[row].isValid()) {
                m_roundPads.emplace_back(row);
            }
        }
        double least = 1e18;
        for (const model::ElementId a : m_roundPads) {
            for (const model::ElementId b : m_roundPads) {
                m_a = a;
                m_b = b;
                const double distance = netOf(a) == netOf(b) ? 1e18 : centreDistance();
                if (distance > 1e6 && distance < least) {
                    least = distance;
                    m_pair = {a, b};
                }
            }
        }
        std::tie(m_a, m_b) = m_pair;
    }
    [[nodiscard]] bool holeIn(const model::Layer& layer, model::ElementId pad) {
        for (std::uint32_t i = layer.elements.first; i < layer.elements.first + layer.elements.count; ++i) {
            const bool isRound = board().elements.kind[i] == model::ElementKind::Circle;
            if (isRound && model::isPlatedHole(board().elements.flags[i]) &&
                centreOf(model::ElementId{i}) == centreOf(pad)) {
                return true;
            }
        }
        return false;
    }
    model::Point centreOf(model::ElementId id) { return board().circles[board().elements.geometry[id.row()]].centre; }
    std::string netOf(model::ElementId id) { return board().nets[board().elements.net[id.row()].row()].name; }
    double centreDistance() {
        return std::hypot(double(centreOf(m_a).x) - centreOf(m_b).x, double(centreOf(m_a).y) - centreOf(m_b).y);
    }
    QPointF screenOf(BoardView& view, model::ElementId id) {
        const model::LayerId layer = board().elements.layer[id.row()];
        const double z = double(view.drawnHeights()[layer.row()].z1) * base::kNmPerMm;
        return *view.controller().screenOf(window().probing().position().toModel(base::toDouble(centreOf(id)), z));
    }
    void measureBoth() {
        m_fixture->key(Qt::Key_M);
        click(flat(), screenOf(flat(), m_a));
        click(flat(), screenOf(flat(), m_b));
        QCOMPARE(list().size(), std::size_t{1});
        m_fixture->key(Qt::Key_M);
    }
    static QImage picture(BoardView& view) {
        base::Result<QImage> image = view.grabPicture();
        return image ? image->convertToFormat(QImage::Format_RGB32) : QImage();
    }
    static void send(BoardView& view, QEvent::Type type, Qt::MouseButton button, QPointF at,
                     Qt::KeyboardModifiers modifiers) {
        const Qt::MouseButtons held = type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::MouseButtons(button);
        QMouseEvent event(type, at, view.mapToGlobal(at), button, held, modifiers);
        QCoreApplication::sendEvent(&view.canvas(), &event);
    }
    static void move(BoardView& view, QPointF at) { send(view, QEvent::MouseMove, Qt::NoButton, at, {}); }
    static void click(BoardView& view, QPointF at, Qt::KeyboardModifiers modifiers = {}) {
        send(view, QEvent::MouseButtonPress, Qt::LeftButton, at, modifiers);
        send(view, QEvent::MouseButtonRelease, Qt::LeftButton, at, modifiers);
    }

    std::unique_ptr<WindowFixture> m_fixture;
    fs::path m_job;
    model::ElementId m_a;
    model::ElementId m_b;
    std::pair<model::ElementId, model::ElementId> m_pair;
    std::vector<model::ElementId> m_roundPads;  ///< with a net, on the uppermost copper layer
};

QTEST_MAIN(MeasureFeatureTest)
#include "measure_feature_test.moc"
