#include "model/session/merge.h"

#include <QtTest>
#include <algorithm>
#include <random>

using model::session::Json;
using model::session::merge;
using model::session::Merged;
using model::session::Unit;

namespace {

Json json(const char* text) {
    std::string quoted = text;
    std::ranges::replace(quoted, '\'', '"');
    return Json::parse(quoted);
}

/// Without the order of what it has.
Json sorted(const Json& part) {
    if (part.is_object()) {
        return Json::parse(nlohmann::json(part).dump());
    }
    std::vector<Json> items = part.is_null() ? std::vector<Json>() : part.get<std::vector<Json>>();
    std::ranges::sort(items);
    return items;
}

bool areSame(const Json& a, const Json& b) {
    return (a.is_null() && b.is_null()) || (a.is_null() == b.is_null() && sorted(a) == sorted(b));
}

Json withoutNothing(Json part) {
    return part.empty() ? Json() : part;
}

/// A part as programs write it, of few names and values, so that two of them often meet.
class Parts {
public:
    explicit Parts(Unit unit, bool isObject) : m_unit(unit), m_isObject(isObject) {}

    Json any() {
        Json part;
        for (int i = 0; i < 5; ++i) {
            part = changed(part, 0, 5);
        }
        return part;
    }
    /// Sets or removes one entry of those from `first` to before `end`.
    Json changed(Json part, int first, int end) {
        const std::string name(1, static_cast<char>('A' + first + number(end - first)));
        if (m_isObject) {
            part = part.is_null() ? Json::object() : part;
            part.erase(name);
            if (number(3) > 0) {
                part[name] = number(3);
            }
            return withoutNothing(part);
        }
        Json list = Json::array();
        for (const Json& item : part) {
            if (item["name"] != name) {
                list.push_back(item);
            }
        }
        if (number(3) > 0) {
            list.push_back({{"name", name}, {"step", "pcb"}, {"value", number(3)}});
        }
        return withoutNothing(list);
    }
    [[nodiscard]] Unit unit() const { return m_unit; }

private:
    int number(int below) { return std::uniform_int_distribution(0, below - 1)(m_dice); }

    Unit m_unit;
    bool m_isObject;
    std::mt19937 m_dice{1};
};

bool has(const Json& part, const Json& item) {
    return std::ranges::find(part, item) != part.end();
}

void kindsOfParts() {
    QTest::addColumn<int>("unit");
    QTest::addColumn<bool>("isObject");
    QTest::newRow("object by keys") << static_cast<int>(Unit::Name) << true;
    QTest::newRow("list by names") << static_cast<int>(Unit::Name) << false;
    QTest::newRow("list of items") << static_cast<int>(Unit::Item) << false;
}

void allKindsOfParts() {
    kindsOfParts();
    QTest::newRow("whole") << static_cast<int>(Unit::Whole) << true;
}

Parts fetchedParts() {
    QFETCH(int, unit);
    QFETCH(bool, isObject);
    return Parts(static_cast<Unit>(unit), isObject);
}

constexpr int kTimes = 2000;

}  // namespace

class MergeTest : public QObject {
    Q_OBJECT

private slots:
    void whatOneSideChangedCounts_data() { allKindsOfParts(); }
    void whatOneSideChangedCounts() {
        Parts parts = fetchedParts();
        for (int i = 0; i < kTimes; ++i) {
            const Json base = parts.any();
            const Json other = parts.any();
            const Merged mine = merge(parts.unit(), base, other, base);
            QVERIFY(mine.part == other && !mine.hasTheirs && !mine.replacesTheirs);
            const Merged theirs = merge(parts.unit(), base, base, other);
            QVERIFY(theirs.part == other && theirs.hasTheirs == (base != other) && !theirs.replacesTheirs);
            const Merged both = merge(parts.unit(), base, other, other);
            QVERIFY(areSame(both.part, other) && !both.hasTheirs && !both.replacesTheirs);
        }
    }

    void changesOfDifferentEntriesAreAllKeptInAnyOrder_data() { kindsOfParts(); }
    void changesOfDifferentEntriesAreAllKeptInAnyOrder() {
        Parts parts = fetchedParts();
        for (int i = 0; i < kTimes; ++i) {
            const Json base = parts.any();
            const Json a = parts.changed(base, 0, 2);
            const Json b = parts.changed(base, 2, 4);
            const Json c = parts.changed(base, 4, 5);
            const auto with = [&](const Json& mine, const Json& theirs) {
                const Merged merged = merge(parts.unit(), base, mine, theirs);
                return merged.replacesTheirs ? Json("replaced") : merged.part;
            };
            QVERIFY(areSame(with(a, with(b, c)), with(with(a, b), c)));
            QVERIFY(areSame(with(a, b), with(b, a)));
        }
    }

    void nothingIsLostThatNoSideRemoved() {
        Parts parts(Unit::Item, false);
        for (int i = 0; i < kTimes; ++i) {
            const Json base = parts.any();
            const Json mine = parts.any();
            const Json theirs = parts.any();
            const Merged merged = merge(Unit::Item, base, mine, theirs);
            QVERIFY(!merged.replacesTheirs);
            for (const Json* side : {&mine, &theirs}) {
                const Json& other = side == &mine ? theirs : mine;
                for (const Json& item : *side) {
                    const bool isRemoved = has(base, item) && !has(other, item);
                    QCOMPARE(has(merged.part, item), !isRemoved);
                }
            }
            for (const Json& item : merged.part) {
                QVERIFY(has(mine, item) || has(theirs, item));
            }
        }
    }

    void whatWasWrittenIsMergedAgainWithoutChange_data() { allKindsOfParts(); }
    void whatWasWrittenIsMergedAgainWithoutChange() {
        Parts parts = fetchedParts();
        for (int i = 0; i < kTimes; ++i) {
            const Json mine = parts.any();
            const Json written = merge(parts.unit(), parts.any(), mine, parts.any()).part;
            QVERIFY(merge(parts.unit(), mine, mine, written).part == written);
        }
    }

    void ofOneNameThisSideCounts() {
        const Merged merged = merge(Unit::Name, json("{'TOP': 1, 'A': 1}"), json("{'TOP': 2, 'A': 1}"),
                                    json("{'TOP': 3, 'A': 5, 'B': 7}"));
        QCOMPARE(merged.part, json("{'TOP': 2, 'A': 5, 'B': 7}"));
        QVERIFY(merged.hasTheirs && merged.replacesTheirs);
    }

    void whatBothRemovedOrSetAlikeIsNoNews() {
        const Merged merged = merge(Unit::Name, json("{'TOP': 1, 'A': 1}"), json("{'TOP': 2}"), json("{'TOP': 2}"));
        QCOMPARE(merged.part, json("{'TOP': 2}"));
        QVERIFY(!merged.hasTheirs && !merged.replacesTheirs);
        const Merged none = merge(Unit::Name, json("{'TOP': 1, 'A': 1}"), json("{'TOP': 1}"), json("{'A': 1}"));
        QVERIFY(none.part.is_null());
    }

    void twoViewsOfOneNameAreTwo() {
        const Json mine = json("[{'name': 'View 1', 'layers': ['TOP']}]");
        const Json theirs = json("[{'name': 'View 1', 'layers': []}]");
        QCOMPARE(merge(Unit::Item, {}, mine, theirs).part.size(), std::size_t{2});
        // Alike ones count, too.
        const Json twice = json("[{'name': 'View 1', 'layers': ['TOP']}, {'name': 'View 1', 'layers': ['TOP']}]");
        QCOMPARE(merge(Unit::Item, twice, mine, twice).part, mine);
        QCOMPARE(merge(Unit::Item, mine, twice, theirs).part, json("[{'name': 'View 1', 'layers': ['TOP']},"
                                                                   " {'name': 'View 1', 'layers': []}]"));
    }

    void ofWhatHasNoEntriesThisSideCounts() {
        const Json mine = json("{'TOP': 1}");
        for (const char* text : {"7", "'text'", "[1, 2]", "true"}) {
            const Merged merged = merge(Unit::Name, {}, mine, json(text));
            QVERIFY(merged.part == mine && merged.replacesTheirs && !merged.hasTheirs);
        }
        QCOMPARE(merge(Unit::Name, json("[7]"), json("[7, {'name': 8}]"), json("[7, null, 'x']")).part,
                 json("[7, {'name': 8}, 'x']"));
    }
};

QTEST_APPLESS_MAIN(MergeTest)
#include "merge_test.moc"
