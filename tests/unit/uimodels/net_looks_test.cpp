#include "ui/models/net_looks.h"

#include <QSignalSpy>
#include <QtTest>
#include <random>
#include <set>

using model::BoardNet;
using model::NetId;
using ui::models::NetLook;
using ui::models::NetLooks;

namespace {

BoardNet net(std::size_t row, std::uint32_t step = 0) {
    return {step, NetId{row}};
}

}  // namespace

class NetLooksTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_looks = std::make_unique<NetLooks>();
        connect(m_looks.get(), &NetLooks::asked, m_looks.get(),
                [this](const QString&, const NetLooks::State& after) { m_looks->setState(after); });
    }

    void netsGetDifferentHuesAndKeepThem() {
        m_looks->colourAnew(std::vector{net(5), net(1), net(9, 2)});
        std::set<QRgb> hues;
        for (const NetLook& look : m_looks->state()) {
            hues.insert(*look.colour);
        }
        QCOMPARE(hues.size(), std::size_t{3});
        const QRgb first = *m_looks->of(net(1)).colour;
        m_looks->colourAnew(std::vector{net(1), net(7)});
        QCOMPARE(m_looks->of(net(1)).colour, std::optional(first));
        QVERIFY(!hues.contains(*m_looks->of(net(7)).colour));
        QVERIFY(!m_looks->of(net(9)).colour);
    }

    void whatSaysNothingHasNoEntry() {
        m_looks->hide(std::vector{net(3)}, true);
        m_looks->colour(std::vector{net(3), net(4)}, 0xff112233);
        m_looks->hide(std::vector{net(3)}, false);
        m_looks->colour(std::vector{net(3)}, std::nullopt);
        QCOMPARE(m_looks->state(), (NetLooks::State{{net(4), 0xff112233, false}}));
        m_looks->hide(std::vector{net(4), net(6)}, true);
        m_looks->clearColours();
        QCOMPARE(m_looks->state(), (NetLooks::State{{net(4), std::nullopt, true}, {net(6), std::nullopt, true}}));
        m_looks->showAll();
        QVERIFY(m_looks->state().empty());
    }

    void theStateIsAlwaysInOrder() {
        std::mt19937 random(3);
        std::map<BoardNet, NetLook> expected;
        for (int round = 0; round < 500; ++round) {
            std::vector<BoardNet> nets;
            for (std::size_t i = random() % 6; i-- > 0;) {
                nets.push_back(net(random() % 20, static_cast<std::uint32_t>(random() % 3)));
            }
            const bool isHidden = random() % 2 == 0;
            m_looks->hide(nets, isHidden);
            for (const BoardNet& one : nets) {
                if (isHidden) {
                    expected[one] = {one, std::nullopt, true};
                } else {
                    expected.erase(one);
                }
            }
            NetLooks::State state;
            for (const auto& [key, look] : expected) {
                state.push_back(look);
            }
            QCOMPARE(m_looks->state(), state);
        }
    }

    void moreColoursThanThereIsRoomForTakeTheNearest() {
        NetLooks::State state;
        for (std::size_t row = 0; row < 100; ++row) {
            state.push_back({net(row), 0xff000000U | static_cast<QRgb>(row * 2), false});
        }
        m_looks->setState(state);
        const std::vector<QRgb> palette = m_looks->palette();
        QCOMPARE(palette.size(), NetLooks::kMostColours);
        QCOMPARE(palette[ui::models::nearestColour(palette, 0xff000004)], QRgb{0xff000004});
        QCOMPARE(ui::models::nearestColour(palette, 0xff0000ff), palette.size() - 1);
    }

private:
    std::unique_ptr<NetLooks> m_looks;
};

QTEST_APPLESS_MAIN(NetLooksTest)
#include "net_looks_test.moc"
