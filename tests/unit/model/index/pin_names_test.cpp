#include "model/index/pin_names.h"

#include <QtTest>

#include "model/board/document_builder.h"

using namespace model;

class PinNamesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        DocumentBuilder builder;
        m_a = builder.addNet("A");
        m_b = builder.addNet("B");
        const auto pin = [&](const char* name, NetId net) {
            Pin made;
            made.name = builder.string(name);
            made.net = net;
            return made;
        };
        Component part;
        part.refdes = "U5";
        builder.addComponent(part, std::vector{pin("U5-3", m_b), pin("U5.4", m_a), pin("12", m_b), pin("U5-", {}),
                                               pin("U50", {}), pin("A1", {}), pin("", {})});
        m_board = builder.finish();
    }

    void theDesignatorBeforeAPinIsLeftOut_data() {
        QTest::addColumn<int>("row");
        QTest::addColumn<QString>("name");
        QTest::newRow("after a dash") << 0 << "3";
        QTest::newRow("after a point") << 1 << "4";
        QTest::newRow("not there") << 2 << "12";
        QTest::newRow("nothing behind it") << 3 << "U5-";
        QTest::newRow("part of a longer name") << 4 << "U50";
        QTest::newRow("letters") << 5 << "A1";
    }
    void theDesignatorBeforeAPinIsLeftOut() {
        QFETCH(int, row);
        QFETCH(QString, name);
        const PinId pin{static_cast<std::size_t>(row)};
        QCOMPARE(QString::fromStdString(pinName(*m_board, pin)), name);
        QCOMPARE(QString::fromStdString(fullPinName(*m_board, pin)), "U5." + name);
    }

    void aPinWithoutANameIsItsComponent() {
        QCOMPARE(pinName(*m_board, PinId{std::size_t{6}}), std::string());
        QCOMPARE(fullPinName(*m_board, PinId{std::size_t{6}}), std::string("U5"));
    }

    void padsOfOneNameAreOnePin() {
        DocumentBuilder builder;
        const auto pin = [&](const char* name) {
            Pin made;
            made.name = builder.string(name);
            return made;
        };
        const auto add = [&](const char* refdes, const std::vector<Pin>& pins) {
            Component part;
            part.refdes = refdes;
            return builder.addComponent(part, pins);
        };
        const ComponentId j7 = add("J7", {pin("1"), pin("MP"), pin(""), pin(""), pin("MP")});
        const ComponentId j8 = add("J8", {pin("MP")});
        const ComponentId second = add("J7", {pin("MP")});
        const ComponentId nameless = add("", {});
        static_cast<void>(add("", {}));
        const auto board = builder.finish();
        const auto pinsAs = [&](std::size_t row) {
            std::vector<std::size_t> rows;
            for (const PinId id : pinsNamedAs(*board, PinId{row})) {
                rows.push_back(id.row());
            }
            return rows;
        };
        QCOMPARE(pinsAs(0), std::vector<std::size_t>{0});
        QCOMPARE(pinsAs(1), (std::vector<std::size_t>{1, 4}));
        QCOMPARE(pinsAs(4), (std::vector<std::size_t>{1, 4}));
        QCOMPARE(pinsAs(2), std::vector<std::size_t>{2});
        QCOMPARE(pinsAs(5), std::vector<std::size_t>{5});
        QCOMPARE(componentsNamedAs(*board, second), (std::vector{j7, second}));
        QCOMPARE(componentsNamedAs(*board, j8), std::vector{j8});
        QCOMPARE(componentsNamedAs(*board, nameless), std::vector{nameless});
    }

    void aComponentsNetsAreNamedOnce() { QCOMPARE(netsOf(*m_board, m_board->components[0]), (std::vector{m_a, m_b})); }

private:
    std::shared_ptr<const Document> m_board;
    NetId m_a, m_b;
};

QTEST_APPLESS_MAIN(PinNamesTest)
#include "pin_names_test.moc"
