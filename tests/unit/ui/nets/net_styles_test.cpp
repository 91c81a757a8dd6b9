#include "ui/nets/net_styles.h"

#include <QSignalSpy>
#include <QtTest>
#include <random>
#include <set>

using model::BoardNet;
using model::NetId;
using ui::NetStyle;
using ui::NetStyles;

namespace {

BoardNet net(std::size_t row, std::uint32_t step = 0) {
    return {step, NetId{row}};
}

}  // namespace

class NetStylesTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_styles = std::make_unique<NetStyles>();
        connect(m_styles.get(), &NetStyles::asked, m_styles.get(),
                [this](const QString&, const NetStyles::State& after) { m_styles->setState(after); });
    }

    void netsGetDifferentHuesAndKeepThem() {
        m_styles->colourAnew(std::vector{net(5), net(1), net(9, 2)});
        std::set<QRgb> hues;
        for (const NetStyle& look : m_styles->state()) {
            hues.insert(*look.colour);
        }
        QCOMPARE(hues.size(), std::size_t{3});
        const QRgb first = *m_styles->of(net(1)).colour;
        m_styles->colourAnew(std::vector{net(1), net(7)});
        QCOMPARE(m_styles->of(net(1)).colour, std::optional(first));
        QVERIFY(!hues.contains(*m_styles->of(net(7)).colour));
        QVERIFY(!m_styles->of(net(9)).colour);
    }

    void whatSaysNothingHasNoEntry() {
        m_styles->hide(std::vector{net(3)}, true);
        m_styles->colour(std::vector{net(3), net(4)}, 0xff112233);
        m_styles->hide(std::vector{net(3)}, false);
        m_styles->colour(std::vector{net(3)}, std::nullopt);
        QCOMPARE(m_styles->state(), (NetStyles::State{{net(4), 0xff112233, false}}));
        m_styles->hide(std::vector{net(4), net(6)}, true);
        m_styles->clearColours();
        QCOMPARE(m_styles->state(), (NetStyles::State{{net(4), std::nullopt, true}, {net(6), std::nullopt, true}}));
        m_styles->showAll();
        QVERIFY(m_styles->state().empty());
    }

    void theStateIsAlwaysInOrder() {
        std::mt19937 random(3);
        std::map<BoardNet, NetStyle> expected;
        for (int round = 0; round < 500; ++round) {
            std::vector<BoardNet> nets;
            for (std::size_t i = random() % 6; i-- > 0;) {
                nets.push_back(net(random() % 20, static_cast<std::uint32_t>(random() % 3)));
            }
            const bool isHidden = random() % 2 == 0;
            m_styles->hide(nets, isHidden);
            for (const BoardNet& one : nets) {
                if (isHidden) {
                    expected[one] = {one, std::nullopt, true};
                } else {
                    expected.erase(one);
                }
            }
            NetStyles::State state;
            for (const auto& [key, look] : expected) {
                state.push_back(look);
            }
            QCOMPARE(m_styles->state(), state);
        }
    }

    void moreColoursThanThereIsRoomForTakeTheNearest() {
        NetStyles::State state;
        for (std::size_t row = 0; row < 100; ++row) {
            state.push_back({net(row), 0xff000000U | static_cast<QRgb>(row * 2), false});
        }
        m_styles->setState(state);
        const std::vector<QRgb> palette = m_styles->palette();
        QCOMPARE(palette.size(), NetStyles::kMostColours);
        QCOMPARE(palette[ui::nearestColour(palette, 0xff000004)], QRgb{0xff000004});
        QCOMPARE(ui::nearestColour(palette, 0xff0000ff), palette.size() - 1);
    }

private:
    std::unique_ptr<NetStyles> m_styles;
};

QTEST_APPLESS_MAIN(NetStylesTest)
#include "net_styles_test.moc"
