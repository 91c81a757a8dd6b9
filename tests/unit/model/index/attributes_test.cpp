#include "model/index/attributes.h"

#include <QtTest>
#include <algorithm>

#include "model/board/document_builder.h"

using namespace model;
using Owner = AttributeValue::Owner;

class AttributesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        DocumentBuilder builder;
        Package package;
        package.name = "R0402";
        const PackageId small = builder.addPackage(package, {});
        const auto add = [&](const char* refdes, const char* value, bool isFitted) {
            std::vector<Property> properties{{builder.string("Value"), builder.string(value)},
                                             {builder.string("Datasheet"), builder.string("")}};
            if (!isFitted) {
                properties.push_back({builder.string(".no_pop"), builder.string("")});
            }
            Component part;
            part.refdes = refdes;
            part.part = "RES";
            part.package = small;
            part.properties = builder.addProperties(properties);
            builder.addComponent(part, {});
        };
        add("R1", "10k", true);
        add("R2", "1k", true);
        add("R3", "10k", false);
        builder.beginLayer(builder.addLayer({}));
        const auto circle = [&](const AttributeValues& attributes) {
            DocumentBuilder::Origin origin;
            origin.attributes = builder.attributes(attributes);
            return builder.addCircle({{0, 0}, 1000, 0}, origin);
        };
        m_pad = circle({{"test_point", ""}});
        circle({});
        m_other = circle({{"test_point", ""}, {"Value", "10k"}});
        m_board = builder.finish();
    }

    void everyValueIsListedOnceWithItsUses() {
        const auto count = [&](Owner owner, const char* name, const char* value) {
            const auto all = listAttributes(*m_board);
            const auto found = std::ranges::find_if(all, [&](const AttributeValue& attribute) {
                return attribute.owner == owner && attribute.name == name && attribute.value == value;
            });
            return found == all.end() ? 0 : static_cast<int>(found->count);
        };
        QCOMPARE(count(Owner::Components, "Value", "10k"), 2);
        QCOMPARE(count(Owner::Components, "Value", "1k"), 1);
        QCOMPARE(count(Owner::Components, "Part", "RES"), 3);
        QCOMPARE(count(Owner::Components, "Package", "R0402"), 3);
        QCOMPARE(count(Owner::Components, ".no_pop", ""), 1);
        QCOMPARE(count(Owner::Components, "Datasheet", ""), 0);
        QCOMPARE(count(Owner::Elements, "test_point", ""), 2);
        QCOMPARE(count(Owner::Elements, "Value", "10k"), 1);
        QCOMPARE(listAttributes(*m_board).size(), std::size_t{7});
    }

    void whatNobodyBuysIsNotInTheBillOfMaterials() {
        QVERIFY(isInBom(*m_board, m_board->components[0]));
        const auto isListed = [](const char* name, const char* value) {
            DocumentBuilder builder;
            Component part;
            part.properties = builder.addProperties(std::vector<Property>{
                {builder.string("Value"), builder.string("LOGO")}, {builder.string(name), builder.string(value)}});
            builder.addComponent(part, {});
            const auto board = builder.finish();
            return isInBom(*board, board->components[0]);
        };
        for (const char* mark : {"exclude_from_bom", "board_only", "virtual"}) {
            QVERIFY2(!isListed(mark, "yes"), mark);
        }
        QVERIFY(isListed("exclude_from_pos_files", "yes"));
        QVERIFY(isListed("dnp", "yes"));  // has a row that says so
        QVERIFY(isListed("virtual", "a name"));
    }

    void aValueLeadsToWhatHasIt() {
        const auto ids = [](std::initializer_list<std::size_t> rows) {
            std::vector<ComponentId> all;
            for (const std::size_t row : rows) {
                all.emplace_back(row);
            }
            return all;
        };
        QCOMPARE(componentsWith(*m_board, {Owner::Components, "Value", "10k", 2}), ids({0, 2}));
        QCOMPARE(componentsWith(*m_board, {Owner::Components, ".no_pop", "", 1}), ids({2}));
        QCOMPARE(componentsWith(*m_board, {Owner::Elements, "Value", "10k", 1}), ids({}));
        QCOMPARE(elementsWith(*m_board, {Owner::Elements, "test_point", "", 2}), (std::vector{m_pad, m_other}));
        QCOMPARE(elementsWith(*m_board, {Owner::Elements, "Value", "10k", 1}), (std::vector{m_other}));
        QVERIFY(elementsWith(*m_board, {Owner::Components, "Value", "10k", 1}).empty());
    }

private:
    std::shared_ptr<const Document> m_board;
    ElementId m_pad, m_other;
};

QTEST_APPLESS_MAIN(AttributesTest)
#include "attributes_test.moc"
