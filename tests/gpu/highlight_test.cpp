#include <QtTest>

#include "model/formats/registry.h"
#include "tests/gpu/gpu_fixture.h"
#include "tests/locations.h"

using namespace render;
using namespace render::test;

namespace {

constexpr std::uint32_t kWidth = 600;
constexpr std::uint32_t kHeight = 450;
constexpr float kAspect = static_cast<float>(kWidth) / kHeight;
constexpr int kStandsOutBy = 60;  // of 255 levels
constexpr double kShare = 0.95;   // of a net's pixels

/// Pixels of a net, and those of them that differ enough from the picture without highlight.
struct Count {
    std::size_t all = 0;
    std::size_t standingOut = 0;
};

Count count(const Image& mask, const Image& before, const Image& after) {
    Count count;
    for (std::uint32_t y = 0; y < kHeight; ++y) {
        for (std::uint32_t x = 0; x < kWidth; ++x) {
            const bool isOfNet = pixel(mask, x, y).r > 127;
            const bool differs = distance(pixel(before, x, y), pixel(after, x, y)) > kStandsOutBy;
            count.all += isOfNet ? 1 : 0;
            count.standingOut += isOfNet && differs ? 1 : 0;
        }
    }
    return count;
}

/// A whole board on the device.
class Board {
public:
    explicit Board(const std::filesystem::path& path) {
        base::Progress progress;
        m_document = *model::readBoard(path, {}, progress);
        m_model = std::make_unique<BoardModel>(*buildBoardModel(*m_document, {}, progress));
        m_scene = std::make_unique<BoardScene>(Gpu::get().device, *m_model);
    }

    [[nodiscard]] const model::Document& document() const { return *m_document; }

    void lookAt(NamedView view, bool is2d) {
        m_settings.is2d = is2d;
        m_scene->setStyles(defaultStyles(*m_document, is2d ? Appearance::Flat : Appearance::Solid));
        m_camera.setOrthographic(is2d);
        m_camera.fit(m_model->boxMin, m_model->boxMax, view, kAspect);
    }

    Image drawPlain() { return draw({}, m_settings); }
    Image drawHighlighted(model::NetId net) { return draw(statesOf(m_document->elementsOf(net)), m_settings); }
    /// White where the net is, whatever covers it.
    Image drawMask(model::NetId net) {
        ViewSettings mono = m_settings;
        mono.isMono = true;
        mono.cull = false;
        std::vector<ElementState> states(m_document->elements.size(), kHidden);
        for (const model::ElementId element : m_document->elementsOf(net)) {
            states[element.row()] = kPlain;
        }
        return draw(states, mono);
    }

private:
    Image draw(const std::vector<ElementState>& states, const ViewSettings& settings) {
        m_scene->setStates(states);
        return *Gpu::get().presenter.render(*m_scene, m_camera, settings, kWidth, kHeight);
    }

    std::shared_ptr<const model::Document> m_document;
    std::unique_ptr<BoardModel> m_model;
    std::unique_ptr<BoardScene> m_scene;
    Camera m_camera;
    ViewSettings m_settings;
};

}  // namespace

/// A highlighted net is seen on whatever layer it lies, and whatever covers it.
class HighlightTest : public QObject {
    Q_OBJECT

private slots:
    void everyNetStandsOut_data() {
        QTest::addColumn<QString>("path");
        QTest::addColumn<int>("view");
        QTest::addColumn<bool>("is2d");
        for (const std::filesystem::path& path : locations::allBoards()) {
            const QString name = QString::fromStdString(path.filename().string());
            const QString text = QString::fromStdString(path.string());
            QTest::addRow("%s, 2D", qPrintable(name)) << text << int(NamedView::Top) << true;
            QTest::addRow("%s, 3D", qPrintable(name)) << text << int(NamedView::Iso) << false;
        }
    }
    void everyNetStandsOut() {
        QFETCH(QString, path);
        QFETCH(int, view);
        QFETCH(bool, is2d);
        Board board(path.toStdString());
        board.lookAt(static_cast<NamedView>(view), is2d);
        const Image before = board.drawPlain();
        const std::size_t nets = board.document().nets.size();
        const std::size_t step = locations::isThorough() ? 1 : std::max<std::size_t>(1, nets / 12);
        std::size_t seen = 0;
        for (std::size_t row = 0; row < nets; row += step) {
            const model::NetId net{row};
            const Count pixels = count(board.drawMask(net), before, board.drawHighlighted(net));
            seen += pixels.all > 0 ? 1 : 0;
            QVERIFY2(double(pixels.standingOut) >= kShare * double(pixels.all),
                     qPrintable(QString("%1: %2 of %3 pixels")
                                    .arg(QString::fromStdString(board.document().nets[row].name))
                                    .arg(pixels.standingOut)
                                    .arg(pixels.all)));
        }
        QVERIFY(seen > 0 || nets == 0);
    }
};

GPU_TEST_MAIN(HighlightTest)
#include "highlight_test.moc"
