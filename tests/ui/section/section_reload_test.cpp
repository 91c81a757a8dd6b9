// The cross-section and the section plane of a board that is read anew, by F5 or because its file was saved.

#include <QMouseEvent>
#include <QtTest>
#include <filesystem>
#include <fstream>

#include "tests/locations.h"
#include "tests/patience.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/paths.h"
#include "ui/section/section_feature.h"
#include "ui/shell/message_bar.h"
#include "ui/workspace/board_watch.h"

namespace fs = std::filesystem;
using base::PointD;
using ui::ActionId;

namespace {

constexpr const char* kSegment = "(start 10 11) (end 15 11)";
constexpr const char* kOutline = "(start 0 0) (end 30 20)";

std::string smallBoard() {
    std::ifstream file(fs::path(locations::kTestData) / "kicad" / "small.kicad_pcb", std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
    return text.replace(text.find(what), what.size(), with);
}

bool isSame(const std::vector<PointD>& a, const std::vector<PointD>& b) {
    return std::ranges::equal(a, b, [](PointD p, PointD q) { return p.x == q.x && p.y == q.y; });
}

}  // namespace

class SectionReloadTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_fixture = std::make_unique<WindowFixture>();
        window().find<ui::BoardWatch>().setQuietMs(100);
        m_board = fs::path(m_fixture->folder().toStdString()) / "small.kicad_pcb";
        write(smallBoard());
        QVERIFY(m_fixture->openAndWait(ui::fromPath(m_board)));
    }
    void cleanup() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void theLineStaysAndTheBoardIsCutAnewWhenItsFileIsSaved() {
        drawLine({12e6, -1e6}, {12e6, -16e6});
        const std::vector<PointD> drawn = line();
        const auto before = copperOnTop();
        QCOMPARE(before.size(), std::size_t{1});
        write(replaced(replaced(smallBoard(), kSegment, "(start 10 12) (end 15 12)"), kOutline,
                       "(start -4 0) (end 30 20)"));
        awaitOther();
        QVERIFY(isSame(line(), drawn));
        QVERIFY(isSame(view().section()->line, drawn));
        const auto after = copperOnTop();
        QCOMPARE(after.size(), std::size_t{1});
        QVERIFY(std::abs(after[0].from - before[0].from - 1e6) < 2.0);  // the track is 1 mm farther along the line
        QVERIFY(!window().messageBar().isVisible());
    }

    void distancesStayToo() {
        drawLine({12e6, -1e6}, {12e6, -16e6});
        const auto copper = copperOnTop();
        const auto clickAt = [&](double along, double z) {
            QTest::mouseClick(&view(), Qt::LeftButton, Qt::ShiftModifier, view().positionOf(along, z).toPoint());
        };
        clickAt(copper[0].from, double(copper[0].top));
        clickAt(copper[0].to, double(copper[0].top));
        const auto dimensions = view().dimensions().all();
        QCOMPARE(dimensions.size(), std::size_t{1});
        readAnew();
        QCOMPARE(view().dimensions().all(), dimensions);
    }

    void aLineAlongANetFollowsItUntilTheNetRunsOtherwise() {
        window().selection().setNets({{0, netNamed("GND")}});
        window().actions()[ActionId::SectionAlongNet].trigger();
        QVERIFY(!view().runs().empty());
        const std::vector<PointD> followed = line();
        readAnew();
        QVERIFY(isSame(line(), followed));
        QVERIFY(!view().runs().empty());
        write(replaced(smallBoard(), kSegment, "(start 9 11) (end 15 11)"));
        awaitOther();
        QVERIFY(isSame(line(), followed));
        QVERIFY(view().section().has_value());
        QVERIFY2(view().runs().empty(), "the band would name layers where the net does not run");
    }

    void aLineThatMeetsNothingAnyMoreIsClosedAndTold() {
        drawLine({27e6, -1e6}, {27e6, -6e6});
        QVERIFY(view().section() && !view().section()->pieces.empty());
        write(narrowBoard());
        awaitOther();
        QVERIFY(!view().section());
        QVERIFY(line().empty());
        QVERIFY(window().messageBar().isVisible());
        QVERIFY2(window().error().contains("does not meet the board"), qPrintable(window().error()));
        QVERIFY(window().find<ui::SectionPanel>().notes().isEmpty());
    }

    void thePlaneOf3dStaysWhereItIs() {
        hover({12e6, -11e6});
        m_fixture->key(Qt::Key_X);
        m_fixture->key(Qt::Key_X, Qt::ShiftModifier);
        m_fixture->key(Qt::Key_Period);
        QVERIFY(window().views().solid().cut() != nullptr);
        const auto before = plane();
        write(replaced(smallBoard(), kOutline, "(start -4 0) (end 30 20)"));  // with another middle
        awaitOther();
        QVERIFY(window().actions()[ActionId::SectionPlane].isChecked());
        QVERIFY(window().views().solid().cut() != nullptr);
        QVERIFY(glm::distance(plane(), before) < 1e-6);
        m_fixture->key(Qt::Key_X);
        readAnew();
        QVERIFY(!window().actions()[ActionId::SectionPlane].isChecked());
        QVERIFY(window().views().solid().cut() == nullptr);
    }

    void aLineThatIsBeingDrawnIsGivenUp() {
        drawLine({12e6, -1e6}, {12e6, -16e6});
        const std::vector<PointD> drawn = line();
        m_fixture->key(Qt::Key_S, Qt::ShiftModifier);
        mouse(QEvent::MouseButtonPress, {5e6, -5e6});
        mouse(QEvent::MouseMove, {9e6, -9e6});
        readAnew();
        QVERIFY(isSame(line(), drawn));
        QVERIFY(!window().actions()[ActionId::DrawSection].isChecked());
        QVERIFY(isSame(view().section()->line, drawn));
        mouse(QEvent::MouseMove, {20e6, -9e6});  // nothing is held any more
        QVERIFY(isSame(line(), drawn));
    }

private:
    [[nodiscard]] TestWindow& window() { return m_fixture->window(); }
    [[nodiscard]] ui::SectionView& view() { return window().find<ui::SectionPanel>().view(); }
    [[nodiscard]] ui::BoardView& flat() { return window().views().flat(); }
    [[nodiscard]] const std::vector<PointD>& line() { return window().find<ui::SectionLine>().line(); }

    void write(const std::string& text) {
        const fs::path beside = m_board.string() + ".new";
        std::ofstream(beside, std::ios::binary) << text;
        fs::rename(beside, m_board);
    }
    /// Ends before the places where the line of a test is.
    static std::string narrowBoard() { return replaced(smallBoard(), kOutline, "(start 0 0) (end 24 20)"); }
    void readAnew() {
        m_before = window().document();
        m_fixture->key(Qt::Key_F5);
        awaitNext();
    }
    void awaitOther() {
        m_before = window().document();
        awaitNext();
    }
    void awaitNext() {
        QTRY_VERIFY(window().document() != m_before && !window().loader().isLoading());
        QVERIFY(window().awaitWork());
    }

    [[nodiscard]] model::NetId netNamed(const std::string& name) {
        const auto& nets = window().document()->nets;
        const auto found = std::ranges::find(nets, name, &model::Net::name);
        return model::NetId{static_cast<std::size_t>(found - nets.begin())};
    }
    [[nodiscard]] std::vector<model::SectionPiece> copperOnTop() {
        std::vector<model::SectionPiece> pieces;
        for (const model::SectionPiece& piece : view().section()->pieces) {
            if (window().document()->layer(piece.layer).name == "Top copper") {
                pieces.push_back(piece);
            }
        }
        return pieces;
    }
    /// How far the plane is from the zero of the job, across itself (mm), and its direction.
    [[nodiscard]] glm::dvec3 plane() {
        const render::SectionPlane& cut = window().views().solid().cut()->plane;
        const base::Point origin = window().workspace().board()->model->origin;
        const glm::dvec2 start = cut.start + glm::dvec2(base::toMm(origin.x), base::toMm(origin.y));
        return {start.x * cut.direction.y - start.y * cut.direction.x, cut.direction.x, cut.direction.y};
    }

    /// Places in nm of the board.
    void mouse(QEvent::Type type, PointD place) {
        const QPointF at = *flat().controller().screenOf(window().probing().position().toModel(place));
        const bool isMove = type == QEvent::MouseMove;
        QMouseEvent event(type, at, flat().mapToGlobal(at), isMove ? Qt::NoButton : Qt::LeftButton,
                          type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton, {});
        QCoreApplication::sendEvent(&flat().canvas(), &event);
    }
    void hover(PointD place) {
        const QPointF at = *flat().controller().screenOf(window().probing().position().toModel(place));
        QMouseEvent event(QEvent::MouseMove, at, flat().mapToGlobal(at), Qt::NoButton, Qt::NoButton, {});
        QCoreApplication::sendEvent(&flat().canvas(), &event);
    }
    void drawLine(PointD from, PointD to) {
        m_fixture->key(Qt::Key_S, Qt::ShiftModifier);
        mouse(QEvent::MouseButtonPress, from);
        mouse(QEvent::MouseMove, to);
        mouse(QEvent::MouseButtonRelease, to);
        QVERIFY(view().section().has_value());
    }

    std::unique_ptr<WindowFixture> m_fixture;
    fs::path m_board;
    const model::Document* m_before = nullptr;
};

QTEST_MAIN(SectionReloadTest)
#include "section_reload_test.moc"
