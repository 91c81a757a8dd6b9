#include "ui/nets/net_model.h"

#include <QAbstractItemModelTester>
#include <QSignalSpy>
#include <QtTest>
#include <ctime>

#include "model/board/document_builder.h"
#include "tests/patience.h"
#include "ui/nets/net_text.h"

using namespace ui;
using model::Nm;

namespace {

constexpr Nm kMm = 1'000'000;

std::shared_ptr<const model::Document> smallBoard() {
    model::DocumentBuilder builder;
    model::Layer copper;
    copper.name = "top";
    copper.type = model::LayerType::Signal;
    const model::NetId net10 = builder.addNet("NET10");
    const model::NetId net2 = builder.addNet("net2");
    const model::NetId gnd = builder.addNet("GND");
    builder.beginLayer(builder.addLayer(copper));
    const auto origin = [](model::NetId net, std::uint8_t flags = 0) {
        model::DocumentBuilder::Origin o;
        o.net = net;
        o.flags = flags;
        return o;
    };
    builder.addLine({{0, 0}, {3 * kMm, 4 * kMm}, kMm, 0}, origin(net2));
    builder.addLine({{0, 0}, {10 * kMm, 0}, kMm, 0}, origin(net2, model::kPad));
    builder.addLine({{0, 0}, {1 * kMm, 0}, kMm, 0}, origin(gnd));
    model::Layer drill;
    drill.type = model::LayerType::Drill;
    builder.beginLayer(builder.addLayer(drill));
    builder.addCircle({{0, 0}, kMm, kMm / 2}, origin(gnd, model::kHole | model::kPlated | model::kVia));
    builder.addCircle({{0, 0}, kMm, kMm / 2}, origin(gnd, model::kHole | model::kPlated | model::kPinHole));
    builder.addCircle({{0, 0}, kMm, kMm}, origin(gnd, model::kHole));
    std::vector<model::Pin> pins(4);
    pins[0].net = pins[1].net = net10;
    pins[2].net = gnd;
    builder.addComponent({}, pins);
    return builder.finish();
}

std::shared_ptr<const model::NetStatistics> statisticsOf(const model::Document& document) {
    base::Progress progress;
    return std::make_shared<const model::NetStatistics>(*model::measureNets(document, progress));
}

QStringList names(const NetModel& nets) {
    QStringList list;
    for (int row = 0; row < nets.rowCount(); ++row) {
        list += nets.index(row, NetModel::Name).data().toString();
    }
    return list;
}

/// Of this thread: other work on the machine does not count.
double cpuMs() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) * 1e3 + static_cast<double>(now.tv_nsec) * 1e-6;
}

}  // namespace

class NetModelTest : public QObject {
    Q_OBJECT

private slots:
    void numbersAreThoseOfTheBoard() {
        const auto board = smallBoard();
        const auto s = statisticsOf(*board);
        QCOMPARE(s->pins, (std::vector<std::uint32_t>{2, 0, 1}));
        QCOMPARE(s->vias, (std::vector<std::uint32_t>{0, 0, 1}));
        QCOMPARE(s->lengthNm, (std::vector<double>{0.0, 5e6, 1e6}));
        QVERIFY(s->areaNm2[1] > s->areaNm2[2] && s->areaNm2[0] == 0.0);
        QCOMPARE(s->nameRank, (std::vector<std::uint32_t>{2, 1, 0}));
        const auto lengths = model::routedLengths(*board, model::NetId{std::size_t{1}});
        QCOMPARE(lengths.size(), std::size_t{1});
        QCOMPARE(lengths[0].second, 5e6);
    }

    void namesAreInTheOrderPeopleCount() {
        const char* const ordered[] = {"", "A", "a", "A1", "a01", "a2", "a2b", "A10", "a10_3", "b", "b2"};
        for (std::size_t i = 0; i < std::size(ordered); ++i) {
            QVERIFY(!model::isNamedBefore(ordered[i], ordered[i]));
            for (std::size_t j = i + 1; j < std::size(ordered); ++j) {
                QVERIFY2(model::isNamedBefore(ordered[i], ordered[j]), ordered[j]);
                QVERIFY2(!model::isNamedBefore(ordered[j], ordered[i]), ordered[j]);
            }
        }
    }

    void highlightedNetsHaveADotInTheColourTheyAreDrawnIn() {
        NetModel nets;
        NetStyles styles;
        nets.setStyles(styles);
        const auto board = smallBoard();
        nets.setNets(board, statisticsOf(*board));
        wait(nets);
        const auto dotOf = [&](std::size_t net) {
            const int row = *nets.rowOf(model::NetId{net});
            const auto dot = nets.index(row, NetModel::Name).data(Qt::DecorationRole).value<QImage>();
            return dot.isNull() ? QRgb{0} : dot.pixel(dot.width() / 2, dot.height() / 2);
        };
        QCOMPARE(dotOf(0), QRgb{0});
        nets.setHighlighted({{0, model::NetId{std::size_t{0}}}, {0, model::NetId{std::size_t{2}}}});
        QCOMPARE(dotOf(0), highlightColour(0));
        QCOMPARE(dotOf(1), QRgb{0});
        QCOMPARE(dotOf(2), highlightColour(1));
        QVERIFY(highlightColour(0) != highlightColour(1));
        styles.setState({{{0, model::NetId{std::size_t{2}}}, qRgb(1, 2, 3), false}});
        QCOMPARE(dotOf(2), qRgb(1, 2, 3));
    }

    void rowsAreFilteredAndSorted() {
        NetModel nets;
        QAbstractItemModelTester tester(&nets, QAbstractItemModelTester::FailureReportingMode::QtTest);
        const auto board = smallBoard();
        nets.setNets(board, statisticsOf(*board));
        wait(nets);
        QCOMPARE(names(nets), (QStringList{"GND", "net2", "NET10"}));
        nets.sort(NetModel::Length, Qt::DescendingOrder);
        wait(nets);
        QCOMPARE(names(nets), (QStringList{"net2", "GND", "NET10"}));
        QCOMPARE(nets.rowOf(model::NetId{std::size_t{0}}), std::optional(2));
        const std::tuple<const char*, NetModel::FilterKind, QStringList> filters[] = {
            {"net", NetModel::FilterKind::Text, {"net2", "NET10"}},
            {"1 NE", NetModel::FilterKind::Text, {"NET10"}},
            {"n?t*", NetModel::FilterKind::Wildcard, {"net2", "NET10"}},
            {"net", NetModel::FilterKind::Wildcard, {}},
            {"^(gnd|net\\d)$", NetModel::FilterKind::Regex, {"net2", "GND"}},
            {"", NetModel::FilterKind::Regex, {"net2", "GND", "NET10"}},
        };
        for (const auto& [pattern, kind, expected] : filters) {
            QVERIFY(nets.setFilter(pattern, kind));
            wait(nets);
            QCOMPARE(names(nets), expected);
        }
        QVERIFY2(!nets.setFilter("(", NetModel::FilterKind::Regex), "half an expression is told");
        wait(nets);
        QCOMPARE(nets.rowCount(), 3);
        QVERIFY(nets.index(0, 0).data(Qt::ToolTipRole).toString().contains("top: 5 mm"));
        QVERIFY(nets.index(1, 0).data(Qt::ToolTipRole).toString().contains("1 pin · 1 via · 1 mm"));
        nets.setNets(nullptr, nullptr);
        QVERIFY(nets.isArranged());
        QCOMPARE(nets.rowCount(), 0);
    }

    void groupsStandUnderHeadings() {
        NetModel nets;
        QAbstractItemModelTester tester(&nets, QAbstractItemModelTester::FailureReportingMode::QtTest);
        model::DocumentBuilder builder;
        for (const char* name : {"GND", "B_N", "A_P", "X", "B_P", "A_N"}) {
            builder.addNet(name);
        }
        const auto board = builder.finish();
        nets.setNets(board, statisticsOf(*board));
        nets.setGrouping(model::NetGrouping::DifferentialPair);
        wait(nets);
        QCOMPARE(names(nets), (QStringList{"A_P/N", "A_N", "A_P", "B_P/N", "B_N", "B_P", "Other nets", "GND", "X"}));
        const auto countBeside = [&](int row) { return nets.index(row, NetModel::Length).data().toString(); };
        QCOMPARE(countBeside(0), QString("2 nets"));
        QVERIFY(countBeside(1) != countBeside(0));  // of a net it is a length
        QCOMPARE(nets.shown(), 6);
        QVERIFY(nets.isHeading(3) && !nets.netAt(3).isValid() && !nets.isHeading(4));
        QCOMPARE(nets.netsAt(3).size(), std::size_t{2});
        nets.sort(NetModel::Name, Qt::DescendingOrder);
        wait(nets);
        QCOMPARE(names(nets).mid(0, 4), (QStringList{"A_P/N", "A_P", "A_N", "B_P/N"}));
        QVERIFY(nets.setFilter("b_", NetModel::FilterKind::Text));
        wait(nets);
        QCOMPARE(names(nets), (QStringList{"B_P/N", "B_P", "B_N"}));
        QVERIFY(nets.setFilter("none", NetModel::FilterKind::Text));
        wait(nets);
        QCOMPARE(nets.rowCount(), 0);
        nets.setGrouping(std::nullopt);
        QVERIFY(nets.setFilter("", NetModel::FilterKind::Text));
        wait(nets);
        QCOMPARE(nets.rowCount(), 6);
    }

    /// There may be no room for it in the cell.
    void tipsHaveTheWholeName() {
        NetModel nets;
        model::DocumentBuilder builder;
        builder.addNet("$1I1342\\PRINTHEAD\\PH_HOME_N");
        builder.addNet("IO\\X");
        nets.setNets(builder.finish(), nullptr);
        nets.setGrouping(model::NetGrouping::Sheet);
        wait(nets);
        const auto tip = [&](int row) { return nets.index(row, NetModel::Name).data(Qt::ToolTipRole).toString(); };
        QVERIFY(tip(0).startsWith("$1I1342, 1 net\n"));
        QVERIFY(tip(2).startsWith("$1I1342\\PRINTHEAD\\PH_HOME_N"));
    }

    void netsWithOverbarsHaveTheirWholeNames() {
        NetModel nets;
        model::DocumentBuilder builder;
        for (const char* name : {"ENC_A\\", "GND", "LV_R\\S\\T\\1"}) {
            builder.addNet(name);
        }
        nets.setNets(builder.finish(), nullptr);
        nets.setGrouping(model::NetGrouping::Sheet);
        wait(nets);
        QCOMPARE(names(nets), (QStringList{"Nets of all sheets", "ENC_A\\", "GND", "LV_R\\S\\T\\1"}));
    }

    void sheetsLieWithinEachOther() {
        NetModel nets;
        QAbstractItemModelTester tester(&nets, QAbstractItemModelTester::FailureReportingMode::QtTest);
        model::DocumentBuilder builder;
        for (const char* name : {"/A/B/X", "GND", "/A/~{Y}", "/Q{slash}R", "/C/D/Z"}) {
            builder.addNet(name);
        }
        const auto board = builder.finish();
        nets.setNets(board, statisticsOf(*board));
        nets.setGrouping(model::NetGrouping::Sheet);
        wait(nets);
        const QStringList all{"/", "Q/R", "A", "Y̅", "B", "X", "C", "D", "Z", "Nets of all sheets", "GND"};
        QCOMPARE(names(nets), all);
        QCOMPARE(nets.index(5, NetModel::Name).data(Qt::EditRole).toString(), "/A/B/X");
        std::vector<int> depths;
        for (int row = 0; row < nets.rowCount(); ++row) {
            depths.push_back(nets.arrangement().depthOf(row));
        }
        QCOMPARE(depths, (std::vector<int>{0, 1, 0, 1, 1, 2, 0, 1, 2, 0, 1}));
        QCOMPARE(nets.netsAt(2).size(), std::size_t{2});
        nets.fold(2, true);
        QVERIFY(nets.arrangement().isFolded(2));
        QCOMPARE(names(nets).mid(1, 3), (QStringList{"Q/R", "A", "C"}));
        nets.sort(NetModel::Length, Qt::DescendingOrder);
        wait(nets);
        QVERIFY2(!nets.rowOf(model::NetId{std::size_t{0}}), "it stays folded");
        QVERIFY(nets.setFilter("y", NetModel::FilterKind::Text));
        wait(nets);
        QCOMPARE(names(nets), (QStringList{"A", "Y̅"}));
        QVERIFY(nets.setFilter("", NetModel::FilterKind::Text));
        wait(nets);
        nets.reveal(model::NetId{std::size_t{0}});
        QCOMPARE(nets.rowOf(model::NetId{std::size_t{0}}), std::optional(5));
    }

    void severalNetsAreToldTogether() {
        const auto board = smallBoard();
        const auto statistics = statisticsOf(*board);
        const std::vector<model::NetId> two{model::NetId{std::size_t{1}}, model::NetId{std::size_t{2}}};
        const QString text = netsText(*board, statistics.get(), two, LengthUnit::Millimetre);
        QVERIFY(text.startsWith("2 nets\n1 pin · 1 via · 6 mm"));
        QVERIFY2(text.contains("differ by 4.0000 mm (157.48 mil)\n"), qPrintable(text));
        QVERIFY(text.contains("top: 6 mm"));
        QVERIFY(netsText(*board, nullptr, {}, LengthUnit::Mil).isEmpty());
    }

    /// By 2 nm, but the table rounds them to 18.4000 and 18.4001 mm.
    void lengthsDifferAsTheTableShowsThem() {
        const auto board = smallBoard();
        model::NetStatistics statistics = *statisticsOf(*board);
        statistics.lengthNm[1] = 18'400'049.0;
        statistics.lengthNm[2] = 18'400'051.0;
        const std::vector<model::NetId> two{model::NetId{std::size_t{1}}, model::NetId{std::size_t{2}}};
        const auto said = [&](LengthUnit unit) { return netsText(*board, &statistics, two, unit).section('\n', 2, 2); };
        QCOMPARE(said(LengthUnit::Millimetre), QString("Their lengths differ by 0.0001 mm (0.00 mil)"));
        QCOMPARE(said(LengthUnit::Mil), QString("Their lengths differ by 0.00 mil (0.0000 mm)"));
    }

    void lastWishWinsWhateverCameBefore() {
        NetModel nets;
        const auto board = smallBoard();
        nets.setNets(board, statisticsOf(*board));
        for (const char* pattern : {"n", "ne", "net", "gnd"}) {
            nets.setFilter(pattern, NetModel::FilterKind::Text);
        }
        wait(nets);
        QCOMPARE(names(nets), QStringList{"GND"});
    }

    void aMillionNetsNeverHoldTheWindowUp() {
        auto board = std::make_shared<model::Document>();
        for (int i = 0; i < 1'000'000; ++i) {
            board->nets.edit().emplace_back().name = "NET_" + std::to_string((i * 7919L) % 1'000'000);
        }
        board->netStart.edit().assign(board->nets.size() + 1, 0);
        const auto statistics = statisticsOf(*board);
        NetModel nets;
        double longest = 0.0;
        const auto step = [&](const auto& what) {
            const double start = cpuMs();
            what();
            longest = std::max(longest, cpuMs() - start);
            while (!nets.isArranged()) {
                const double before = cpuMs();
                QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents);
                longest = std::max(longest, cpuMs() - before);
            }
        };
        step([&] { nets.setNets(board, statistics); });
        QCOMPARE(nets.rowCount(), 1'000'000);
        QCOMPARE(nets.index(10, 0).data().toString(), "NET_10");
        step([&] { nets.sort(NetModel::Name, Qt::DescendingOrder); });
        QCOMPARE(nets.index(0, 0).data().toString(), "NET_999999");
        step([&] { nets.setGrouping(model::NetGrouping::Bus); });
        step([&] { nets.setGrouping(model::NetGrouping::DifferentialPair); });
        QCOMPARE(nets.index(0, 0).data().toString().left(10), "Other nets");
        step([&] { nets.setFilter("99", NetModel::FilterKind::Text); });
        step([&] { nets.setFilter("_9*9", NetModel::FilterKind::Regex); });
        QVERIFY2(longest < 100.0, qPrintable(QStringLiteral("%1 ms").arg(longest)));
    }

private:
    static void wait(const NetModel& nets) { QTRY_VERIFY(nets.isArranged()); }
};

QTEST_GUILESS_MAIN(NetModelTest)
#include "net_model_test.moc"
