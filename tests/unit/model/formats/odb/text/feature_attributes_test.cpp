#include "model/formats/odb/text/feature_attributes.h"

#include "model/formats/odb/features/features.h"
#include "tests/unit/model/formats/odb/odb_testing.h"

using model::AttributeValues;
using model::Diagnostics;
using model::odb::AttributeTypes;
using model::odb::FeatureAttributes;
using model::odb::FeatureFile;
using model::odb::parseFeatures;
using namespace odb_testing;

namespace {

constexpr auto kHead =
    "@0 .pad_usage\n@1 .string\n@2 .smd\n@5 .string_angle\n@6 mine\n&0 first; one\n&1 second\n$0 r1\n";

FeatureFile parse(const std::string& text) {
    Diagnostics diagnostics;
    return parseFeatures(text, "features", model::odb::Unit::Millimetre, diagnostics);
}

AttributeValues valuesOf(const std::string& tail, const AttributeTypes& types = {}) {
    const FeatureFile file = parse(kHead + ("P 1 2 0 P 0 0" + tail) + "\n");
    const std::uint32_t set = file.features[0].attributes;
    return set == FeatureAttributes::kNone ? AttributeValues{} : file.attributes.values(set, types);
}

}  // namespace

class FeatureAttributesTest : public QObject {
    Q_OBJECT

private slots:
    void valuesAreWhatTheirTypeSays() {
        QCOMPARE(valuesOf(";0=1,1=0,2,5=12.5;ID=7"),
                 (AttributeValues{
                     {".pad_usage", "via"}, {".string", "first; one"}, {".smd", "yes"}, {".string_angle", "12.5"}}));
        // An unknown type, an option without a text and a text that is not listed stay as written.
        QCOMPARE(valuesOf(";6=1,0=77,1=9"), (AttributeValues{{"mine", "1"}, {".pad_usage", "77"}, {".string", "9"}}));
    }

    void tailsComeInManyForms() {
        QVERIFY(valuesOf("").empty());
        QVERIFY(valuesOf(";").empty());
        QVERIFY(valuesOf(";;ID=7").empty());
        QVERIFY(valuesOf(" ;ID=7").empty());  // no attribute has that name
        QCOMPARE(valuesOf(" ; 2 ;ID=7"), (AttributeValues{{".smd", "yes"}}));
        QVERIFY(valuesOf(";3=1,x,-1=2,99999999999=1").empty());
    }

    void typesComeFromTheJob() {
        AttributeTypes types;
        Diagnostics diagnostics;
        types.read(
            "OPTION {\n NAME=mine\n OPTIONS=red;green; blue\n}\nTEXT {\n NAME=.smd\n}\nINTEGER {\n NAME=.string\n}\n",
            "misc/userattr", diagnostics);
        QCOMPARE(valuesOf(";6=2,2=1,1=0", types),
                 (AttributeValues{{"mine", "blue"}, {".smd", "second"}, {".string", "0"}}));
        QVERIFY(diagnostics.entries().empty());
    }

    void blanksMayPartEntries() {
        const AttributeTypes types;
        const AttributeValues three = valuesOf(";1=7,2=8,6=9", types);
        QCOMPARE(three.size(), std::size_t{3});
        QCOMPARE(valuesOf(";1=7 2=8 6=9", types), three);
        QCOMPARE(valuesOf("; 1 = 7 , 2= 8  6 =9 ", types), three);
        QCOMPARE(valuesOf(";1 2", types).size(), std::size_t{2});
    }

    void routedFeaturesSayThemselvesWhetherTheyArePlated() {
        using model::Plating;
        const FeatureFile file = parse(
            "@0 .rout_plated\n@1 .drill\n$0 r1\nL 0 0 1 0 0 P 0;0\nL 0 1 1 1 0 P 0\nL 0 2 1 2 0 P 0;0=1\n"
            "L 0 3 1 3 0 P 0;0=0\nL 0 4 1 4 0 P 0;0,1=2\nL 0 5 1 5 0 P 0;1=1,0\n");
        const Plating expected[] = {Plating::Plated,  Plating::NotSaid, Plating::Plated,
                                    Plating::NotSaid, Plating::Via,     Plating::NonPlated};
        for (std::size_t i = 0; i < std::size(expected); ++i) {
            QVERIFY2(file.features[i].plating == expected[i], std::to_string(i).c_str());
        }
    }

    void equalSetsAreKeptOnce() {
        std::string text = kHead;
        for (int i = 0; i < 100; ++i) {
            text += "P 1 2 0 P 0 0;0=" + std::to_string(i % 3) + ";ID=" + std::to_string(i) + "\n";
        }
        const FeatureFile file = parse(text);
        QCOMPARE(file.attributes.sets.size(), std::size_t{3});
        for (std::size_t i = 0; i < 100; ++i) {
            QCOMPARE(file.features[i].attributes, static_cast<std::uint32_t>(i % 3));
        }
    }

    void badTableLinesAreReported() {
        Diagnostics diagnostics;
        (void)parseFeatures("@x .drill\n&-1 text\n@99999999 .x\n", "features", model::odb::Unit::Inch, diagnostics);
        QVERIFY(findDiagnostic(diagnostics, "the attribute line is not") != nullptr);
        QCOMPARE(findDiagnostic(diagnostics, "the attribute line is not")->count, 3U);
    }

    void elementsCarryTheSetOfTheirFeature() {
        const Folder folder;
        writeSmallJob(folder,
                      "UNITS=MM\n@0 colour\n@1 .smd\n$0 r100\nL 0 0 1 0 0 P 0;0=1\nL 1 0 2 0 0 P 0;0=1\n"
                      "L 2 0 3 0 0 P 0;1\nP 5 5 0 P 0 0;0=1\nP 6 6 0 P 0 0\n"
                      "S P 0;1\nOB 10 10 I\nOS 20 10\nOS 20 20\nOS 10 10\nOE\nSE\n");
        folder.write("misc/userattr", "OPTION {\n NAME=colour\n OPTIONS=red;green\n}\n");
        const auto d = read(folder.path());
        const auto of = [&](std::uint32_t feature) { return d->attributesOf(elementOf(*d, "TOP", feature)); };
        QCOMPARE(of(0), (AttributeValues{{"colour", "green"}}));
        QCOMPARE(of(2), (AttributeValues{{".smd", "yes"}}));  // other attributes end the trail
        QCOMPARE(of(3), of(0));
        QVERIFY(of(4).empty());
        QCOMPARE(of(5), of(2));
        QCOMPARE(d->attributeSets.size(), std::size_t{2});
        QCOMPARE(d->elements.attributes.size(), d->elements.size());
    }
};

QTEST_APPLESS_MAIN(FeatureAttributesTest)
#include "feature_attributes_test.moc"
