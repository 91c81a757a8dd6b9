// Measuring in a cross-section with real mouse and key events on the sample board, and what is saved of it.
#include "ui/section/section_dimensions.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QStatusBar>
#include <QToolTip>
#include <QtTest>

#include "tests/locations.h"
#include "tests/patience.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/table_view.h"
#include "ui/section/section_feature.h"

using model::SectionPiece;
using ui::ActionId;
using ui::LengthUnit;

class SectionDimensionsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_fixture = std::make_unique<WindowFixture>();
        m_board = m_fixture->copyOfSample();
        QVERIFY(m_fixture->openAndWait(m_board));
        const model::Box& board = window().document()->board;
        const double y = (double{1} * board.min.y + board.max.y) / 2;
        m_line = {{double(board.min.x), y}, {double(board.max.x), y}};
    }
    void init() {
        m_fixture->key(Qt::Key_Escape);
        sections().cutAlong({});
        sections().cutAlong(m_line);
        window().find<ui::SectionPanel>().show();
        ui::FeatureContext::raise(window().find<ui::SectionPanel>());
    }
    void cleanupTestCase() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void edgesAreMeasuredAcrossAndCornersBothWays() {
        showOnePiece();
        const double middle = (m_piece.from + m_piece.to) / 2;
        const double half = (double(m_piece.bottom) + double(m_piece.top)) / 2;
        clickAt(m_piece.from, half, Qt::ShiftModifier);
        QVERIFY(view().dimensions().from() && view().dimensions().all().empty());
        clickAt(m_piece.to, half, Qt::ShiftModifier);
        QCOMPARE(ui::dimensionText(last(), LengthUnit::Millimetre), QString("6 mm (236.22 mil)"));
        QCOMPARE(ui::dimensionText(last(), LengthUnit::Mil), QString("236.22 mil (6 mm)"));
        clickAt(middle, m_piece.bottom, Qt::ShiftModifier);
        clickAt(middle, m_piece.top, Qt::ShiftModifier);
        QVERIFY(last().isUpright());
        QCOMPARE(last().length(), double(m_piece.top - m_piece.bottom));
        clickAt(m_piece.from, m_piece.bottom, Qt::ShiftModifier);
        clickAt(m_piece.to, m_piece.top, Qt::ShiftModifier);
        QCOMPARE(last().along(), m_piece.to - m_piece.from);
        QCOMPARE(last().height(), double(m_piece.top - m_piece.bottom));
        QVERIFY(ui::dimensionText(last(), LengthUnit::Millimetre).contains("; 6 mm along, "));
        QCOMPARE(view().dimensions().all().size(), std::size_t{3});
        QVERIFY(window().selection().selected().empty());
        QTest::mouseClick(&view(), Qt::LeftButton, {}, view().positionOf(middle, half).toPoint());
        QCOMPARE(view().dimensions().all().size(), std::size_t{3});  // a click selects, and they stay
    }

    void withTheKeyMClicksMeasureHereToo() {
        showOnePiece();
        const double half = (double(m_piece.bottom) + double(m_piece.top)) / 2;
        m_fixture->key(Qt::Key_M);
        QVERIFY(window().actions()[ActionId::MeasurePoints].isChecked());
        QVERIFY(view().isMeasuring());
        clickAt(m_piece.from, half);
        const QImage before = view().grab().toImage();
        QTest::mouseMove(&view(), pixel(m_piece.to, half));
        QVERIFY(differingPixels(before, view().grab().toImage()) > 100);  // the distance is there before the click
        clickAt(m_piece.to, half);
        QCOMPARE(view().dimensions().all().size(), std::size_t{1});
        QCOMPARE(last().length(), m_piece.to - m_piece.from);
        clickAt(m_piece.from, half);
        m_fixture->key(Qt::Key_Escape);  // gives up the click, or the tool and the click
        QVERIFY(!view().dimensions().from());
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(!view().isMeasuring());
        clickAt(m_piece.from, half);
        QVERIFY(!view().dimensions().from());
        QTest::keyClick(&view(), Qt::Key_Delete);
        QVERIFY(view().dimensions().all().empty());
    }

    void theStatusLineSaysWhatAClickIntoTheSectionMeasures() {
        showOnePiece();
        const double half = (double(m_piece.bottom) + double(m_piece.top)) / 2;
        point(true);
        m_fixture->key(Qt::Key_M);  // the pointer is on the section
        QCOMPARE(said(), QString("Click the first edge or corner of the section"));
        clickAt(m_piece.from, half);
        QCOMPARE(said(), QString("Click the second edge or corner"));
        clickAt(m_piece.to, half);
        QCOMPARE(said(), QString("6 mm (236.22 mil)"));
        point(false);
        QCOMPARE(said(), QString("6 mm (236.22 mil)"));
        hoverFlat();
        QVERIFY2(said().startsWith("Click the first point"), qPrintable(said()));
        point(true);
        QCOMPARE(said(), QString("Click the first edge or corner of the section"));
        m_fixture->key(Qt::Key_Escape);
        QVERIFY2(said().isEmpty(), qPrintable(said()));
        clickAt(m_piece.from, half, Qt::ShiftModifier);
        QCOMPARE(said(), QString("Click the second edge or corner"));
        m_fixture->key(Qt::Key_Escape);
        QVERIFY2(said().isEmpty(), qPrintable(said()));
        point(false);
    }

    void aClickThatMeetsNothingSaysSo() {
        showOnePiece();
        point(true);
        m_fixture->key(Qt::Key_M);
        const QPoint beside = pixel((m_piece.from + m_piece.to) / 2, double(m_piece.top)) - QPoint(0, 30);
        QVERIFY(!view().locationAt(beside));
        QTest::mouseClick(&view(), Qt::LeftButton, {}, beside);
        QCOMPARE(said(), QString("There is no edge or corner of the section under the pointer"));
        sections().cutAlong({});
        QTest::mouseClick(&view(), Qt::LeftButton, {}, beside);
        QCOMPARE(said(), QString("There is no section to measure: draw one first"));
        QVERIFY(view().dimensions().all().empty());
        m_fixture->key(Qt::Key_Escape);
        QVERIFY2(said().isEmpty(), "it goes with the tool");
        point(false);
    }

    void nothingIsDescribedWhileMeasuring() {
        showOnePiece();
        const QPoint at = pixel((m_piece.from + m_piece.to) / 2, (double(m_piece.bottom) + double(m_piece.top)) / 2);
        const auto isDescribed = [&] {
            QHelpEvent help(QEvent::ToolTip, at, view().mapToGlobal(at));
            QCoreApplication::sendEvent(&view(), &help);
            return QToolTip::isVisible() && !QToolTip::text().isEmpty();
        };
        QVERIFY(isDescribed());
        m_fixture->key(Qt::Key_M);
        QTRY_VERIFY(!QToolTip::isVisible());
        QVERIFY(!isDescribed());
        m_fixture->key(Qt::Key_M);
        QVERIFY(isDescribed());
        clickAt(m_piece.from, double(m_piece.bottom), Qt::ShiftModifier);
        QTRY_VERIFY(!QToolTip::isVisible());
        QVERIFY(!isDescribed());  // until the second click
        clickAt(m_piece.to, double(m_piece.bottom), Qt::ShiftModifier);
        QTRY_VERIFY(isDescribed());
        QToolTip::hideText();
    }

    void theyAreSavedWithTheSectionAndRecalledWithIt() {
        m_fixture->key(Qt::Key_B, Qt::ControlModifier | Qt::AltModifier);
        QCOMPARE(sections().saved().size(), std::size_t{1});
        m_fixture->key(Qt::Key_M);
        const SectionPiece piece = aWideCopperPiece();
        measure(piece);
        measureHeight(piece);
        m_fixture->key(Qt::Key_M);
        QCOMPARE(sections().saved()[0].dimensions, view().dimensions().all());
        QCOMPARE(sections().saved()[0].dimensions.size(), std::size_t{2});

        // As another run of the program finds them.
        window().awaitFiles();
        const auto found = model::session::loadSession(m_board.toStdString(), *window().document());
        QVERIFY(found.ignored.empty());
        QCOMPARE(found.session.sections, sections().saved());
        const auto wanted = view().dimensions().all();
        sections().cutAlong({});
        QVERIFY(view().dimensions().all().empty());
        choose(0);
        QCOMPARE(view().dimensions().all(), wanted);
        QVERIFY(!view().isStale(wanted[0]) && !view().isStale(wanted[1]));
        window().actions()[ActionId::Undo].trigger();
        QCOMPARE(view().dimensions().all().size(), std::size_t{1});
        window().actions()[ActionId::Redo].trigger();
        QCOMPARE(view().dimensions().all(), wanted);
    }

    void ofTwoSectionsOfOneLineEachKeepsItsOwn() {
        const auto save = [this] { m_fixture->key(Qt::Key_B, Qt::ControlModifier | Qt::AltModifier); };
        const auto of = [this](std::size_t row) { return sections().saved()[row].dimensions.size(); };
        while (!sections().saved().empty()) {
            emit list().deleteRequested({0});
        }
        view().setDimensions({});
        save();
        save();
        choose(1);
        m_fixture->key(Qt::Key_M);
        const SectionPiece piece = aWideCopperPiece();
        measure(piece);
        measureHeight(piece);
        m_fixture->key(Qt::Key_M);
        QCOMPARE(of(0), std::size_t{0});
        QCOMPARE(of(1), std::size_t{2});
        QCOMPARE(view().dimensions().all(), sections().saved()[1].dimensions);
        QAbstractItemModel& names = *list().model();
        QVERIFY(names.setData(names.index(0, 0), "Other"));
        QCOMPARE(view().dimensions().all().size(), std::size_t{2});
        window().actions()[ActionId::Undo].trigger();  // the names are others again
        QCOMPARE(view().dimensions().all().size(), std::size_t{2});
        emit list().deleteRequested({0});
        QCOMPARE(list().currentIndex().row(), 0);
        QCOMPARE(view().dimensions().all(), sections().saved()[0].dimensions);
    }

    void otherHeightsMakeThemStale() {
        m_fixture->key(Qt::Key_M);
        const SectionPiece piece = aWideCopperPiece();
        measureHeight(piece);
        m_fixture->key(Qt::Key_M);
        QVERIFY(!view().isStale(last()));
        const auto board = std::make_shared<const model::Document>(*window().document());
        auto thicker = std::make_shared<model::Document>(*board);
        for (model::Layer& layer : thicker->layers) {
            layer.z += 70'000;
        }
        window().workspace().restack(thicker, {}, true);
        QVERIFY(view().isStale(last()));
        window().workspace().restack(board, {}, true);
        QVERIFY(!view().isStale(last()));
    }

    void bothViewsGoToARecalledSection() {
        if (sections().saved().empty()) {
            m_fixture->key(Qt::Key_B, Qt::ControlModifier | Qt::AltModifier);
        }
        sections().cutAlong({});
        ui::BoardView& flat = window().views().flat();
        ui::BoardView& solid = window().views().solid();
        flat.controller().zoomAtCentre(50.0F);
        solid.controller().look(render::NamedView::Iso);
        const auto before = solid.controller().camera().pose();
        choose(0);
        for (const base::PointD end : m_line) {
            const auto at = flat.screenOf(end);
            QVERIFY(at && flat.rect().contains(at->toPoint()));
            const auto in3d = solid.controller().screenOf(solid.position().toModel(end));
            QVERIFY(in3d && solid.rect().contains(in3d->toPoint()));
        }
        QVERIFY(solid.cut() != nullptr);
        const auto pose = solid.controller().camera().pose();
        QVERIFY(pose.yaw != before.yaw || pose.pitch != before.pitch);
        QVERIFY(std::abs(pose.yaw) < 1e-3F);  // straight at the face: the line runs along x
        QVERIFY(view().height() >= 150);
    }

private:
    [[nodiscard]] TestWindow& window() { return m_fixture->window(); }
    [[nodiscard]] ui::SectionFeature& sections() { return window().sections(); }
    [[nodiscard]] ui::SectionView& view() { return window().find<ui::SectionPanel>().view(); }
    [[nodiscard]] const model::SectionDimension& last() { return view().dimensions().all().back(); }
    [[nodiscard]] QPoint pixel(double along, double z) { return view().positionOf(along, z).toPoint(); }
    void clickAt(double along, double z, Qt::KeyboardModifiers modifiers = {}) {
        QTest::mouseClick(&view(), Qt::LeftButton, modifiers, pixel(along, z));
    }
    [[nodiscard]] QString said() { return window().statusBar()->currentMessage(); }
    /// The pointer comes to the section, or leaves it.
    void point(bool isOn) {
        QEnterEvent enter({5, 5}, {5, 5}, {5, 5});
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(&view(), isOn ? static_cast<QEvent*>(&enter) : &leave);
    }
    void hoverFlat() {
        ui::BoardView& flat = window().views().flat();
        const QPointF at = flat.rect().center();
        QMouseEvent event(QEvent::MouseMove, at, flat.mapToGlobal(at), Qt::NoButton, Qt::NoButton, {});
        QCoreApplication::sendEvent(&flat.canvas(), &event);
    }
    [[nodiscard]] ui::TableView& list() { return window().find<ui::SectionPanel>().list(); }
    void choose(int row) {
        const QRect location = list().visualRect(list().model()->index(row, 0));
        QTest::mouseClick(list().viewport(), Qt::LeftButton, {}, location.center());
    }
    /// Large enough that edges are caught far from corners.
    void showOnePiece() {
        const model::BoardElement any{0, model::ElementId{0U}};
        const model::Nm thickness = window().document()->boardThickness;
        m_piece = {model::LayerId{std::size_t{0}}, any, 2e6, 8e6, thickness / 4, thickness};
        model::Section section;
        section.line = {{0, 0}, {10e6, 0}};
        section.stations = {0, 10e6};
        section.pieces = {m_piece};
        base::Progress progress;
        view().setSection(*model::indexBoard(std::make_shared<model::Document>(*window().document()), progress),
                          section);
        view().setDimensions({});
        view().fit();
    }
    /// From edge to edge: pieces are zoomed to, so that their edges are far from others.
    void measure(const SectionPiece& piece) {
        const double half = (double(piece.bottom) + double(piece.top)) / 2;
        clickAt(piece.from, half);
        clickAt(piece.to, half);
    }
    void measureHeight(const SectionPiece& piece) {
        const double middle = (piece.from + piece.to) / 2;
        clickAt(middle, piece.bottom);
        clickAt(middle, piece.top);
    }
    [[nodiscard]] SectionPiece aWideCopperPiece() {
        const std::vector<SectionPiece> merged = model::merged(view().section()->pieces);
        const auto widest = std::ranges::max_element(merged, {}, [](const SectionPiece& piece) {
            return piece.material == model::SectionMaterial::Copper ? piece.to - piece.from : 0.0;
        });
        return *widest;
    }

    std::unique_ptr<WindowFixture> m_fixture;
    QString m_board;
    std::vector<base::PointD> m_line;
    SectionPiece m_piece;
};

QTEST_MAIN(SectionDimensionsTest)
#include "section_dimensions_test.moc"
