// Files of IPC-2581 that are wrong in one place: a message with file and line, and the rest of the board is shown.

#include <QTemporaryDir>
#include <QtTest>
#include <algorithm>

#include "model/formats/registry.h"
#include "model/text/whole_file.h"

using namespace model;

namespace {

/// What of a file is written otherwise than it should be.
struct Parts {
    std::string root = "<IPC-2581 revision='C'>";
    std::string content{};
    std::string header = "<CadHeader units='MILLIMETER'/>";
    std::string layers =
        "<Layer name='T' layerFunction='CONDUCTOR' side='TOP'/><Layer name='B' layerFunction='CONDUCTOR' "
        "side='BOTTOM'/>";
    std::string step{};   ///< in the step that is shown
    std::string steps{};  ///< beside it
};

constexpr const char* kTrack =
    "<LayerFeature layerRef='T'><Set net='A'><Features><Location x='0' y='0'/><Line startX='1' startY='1' endX='9' "
    "endY='1'><LineDesc lineWidth='0.2' lineEnd='ROUND'/></Line></Features></Set></LayerFeature>";

/// A track on T is in every file, before and behind of which things are wrong. What is wrong stands on line 2.
std::string textOf(const Parts& parts) {
    return parts.root + "<Content>" + parts.content + "</Content><Ecad>" + parts.header + "<CadData>" + parts.layers +
           "<Step name='s'>" + kTrack + parts.step + "</Step>" + parts.steps + "</CadData></Ecad></IPC-2581>";
}

base::Result<std::shared_ptr<const Document>> open(const QTemporaryDir& folder, const std::string& text) {
    const std::filesystem::path path = folder.filePath("bad.xml").toStdString();
    if (!writeWholeFile(path, text).ok()) {
        qFatal("the file cannot be written");
    }
    base::Progress progress;
    return readBoard(path, {}, progress);
}

/// The message with these words, or that begins with them but for the capital; null if there is none.
const Diagnostic* find(const Document& board, std::string_view words) {
    words.remove_prefix(1);
    const auto& entries = board.diagnostics.entries();
    const auto found = std::ranges::find_if(
        entries, [&](const Diagnostic& entry) { return entry.text.find(words) != std::string::npos; });
    return found == entries.end() ? nullptr : &*found;
}

bool hasTheTrack(const Document& board) {
    return std::ranges::any_of(board.elementCountsWithCopies(), [](std::uint64_t count) { return count > 0; });
}

std::string inStep(const std::string& item) {
    return "\n" + item;
}

std::string far(const char* x) {
    return inStep("<LayerFeature layerRef='B'><Set><Hole diameter='1' x='" + std::string(x) +
                  "' y='0' platingStatus='VIA'/></Set></LayerFeature>");
}

}  // namespace

class IpcBadInputTest : public QObject {
    Q_OBJECT

private slots:
    void aMessageNamesThePlaceAndTheRestIsShown_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("message");
        const auto row = [](const char* name, const Parts& parts, const char* message) {
            QTest::newRow(name) << QByteArray::fromStdString(textOf(parts)) << QByteArray(message);
        };
        const auto step = [&](const char* name, const std::string& item, const char* message) {
            row(name, {.step = item}, message);
        };
        step("layer", inStep("<LayerFeature layerRef='no'><Set/></LayerFeature>"), "layer that is not listed");
        step("shape",
             inStep("<LayerFeature layerRef='B'><Set><Features><StandardPrimitiveRef id='no'/></Features></Set>"
                    "</LayerFeature>"),
             "entry that no dictionary has");
        step("line",
             inStep("<LayerFeature layerRef='B'><Set><Features><Line startX='1' startY='1' endX='2' endY='1'>"
                    "<LineDescRef id='no'/></Line></Features></Set></LayerFeature>"),
             "LineDescRef refers to an entry");
        step("padstack",
             inStep("<LayerFeature layerRef='B'><Set><Pad padstackDefRef='no'><Location x='1' y='1'/></Pad>"
                    "</Set></LayerFeature>"),
             "a pad has no shape");
        step("component",
             inStep("<LayerFeature layerRef='B'><Set><Pad><Location x='1' y='1'/><Circle diameter='1'/>"
                    "<PinRef componentRef='no' pin='1'/></Pad></Set></LayerFeature>"),
             "a pad names a component");
        step("package", inStep("<Component refDes='R' packageRef='no' layerRef='T'/>"), "names a package");
        step("pin of a net", inStep("<LogicalNet name='A'><PinRef componentRef='no' pin='1'/></LogicalNet>"),
             "a net names a component");
        step("step", inStep("<StepRepeat stepRef='no' x='0' y='0' nx='1' ny='1'/>"),
             "a step that the file does not have");
        step("stackup of a zone", inStep("<StackupZone name='z' stackupRef='no'/>"), "names a stackup");
        row("row of a stackup",
            {.layers = Parts().layers +
                       "<Stackup name='p'><StackupGroup name='g'>\n<StackupLayer layerOrGroupRef='no' thickness='1' "
                       "sequence='1'/></StackupGroup></Stackup>"},
            "row for a layer that is not listed");
        row("span",
            {.layers =
                 Parts().layers + "\n<Layer name='D' layerFunction='DRILL'><Span fromLayer='no' toLayer='B'/></Layer>"},
            "ends at no copper layer");
        step("the step in itself", inStep("<StepRepeat stepRef='s' x='0' y='0' nx='2' ny='2'/>"), "contains itself");
        row("steps in each other",
            {.step = "<StepRepeat stepRef='a' x='0' y='0' nx='1' ny='1'/>",
             .steps = "<Step name='a'>" + std::string(kTrack) +
                      "<StepRepeat stepRef='b' x='0' y='0' nx='1' ny='1'/></Step>"
                      "<Step name='b'>\n<StepRepeat stepRef='a' x='0' y='0' nx='1' ny='1'/></Step>"},
            "contains itself");
        row("very many copies",
            {.step = inStep("<StepRepeat stepRef='a' x='0' y='0' dx='0.001' dy='0.001' nx='90000' ny='90000'/>"),
             .steps = "<Step name='a'>" + std::string(kTrack) + "</Step>"},
            "more than 100000 copies, the limit");
        step("no count", inStep("<StepRepeat stepRef='s' x='0' y='0' nx='1e9' ny='1'/>"),
             "counts none or more than 100000");
        row("no units of a dictionary", {.content = "\n<DictionaryStandard/>"}, "dictionary names no units");
        row("no units", {.header = "\n<CadHeader/>"}, "names no units");
        row("unknown units", {.header = "\n<CadHeader units='CUBIT'/>"}, "names no units");
        row("units of a dictionary", {.content = "\n<DictionaryStandard units='ELL'/>"}, "dictionary names no units");
        step("far away", far("2000"), "more than 1.07 m");
        step("farther than numbers of 32 bits", far("1e12"), "more than 1.07 m");
        step("farther than any number", far("1e999"), "is missing or no number");
        step("no number", far("NaN"), "is missing or no number");
        step("a foreign element",
             inStep("<LayerFeature layerRef='B'><Set><Features><Spline/></Features></Set>"
                    "</LayerFeature>"),
             "element Spline is of no kind");
        row("a newer revision", {.root = "\n<IPC-2581 revision='D'>"}, "revision D");
    }
    /// As a file for fabrication or a stencil: not wrong.
    void padsMayNameComponentsWhereNoneAreListed() {
        const std::string pad = inStep(
            "<LayerFeature layerRef='B'><Set><Pad><Location x='1' y='1'/><Circle diameter='1'/>"
            "<PinRef componentRef='no' pin='1'/></Pad></Set></LayerFeature>");
        const std::string part = "<Component refDes='R' packageRef='no' layerRef='T'/>";
        const QTemporaryDir folder;
        const auto none = open(folder, textOf({.step = pad}));
        const Diagnostic* const info = find(**none, "a pad names a component, of which the step lists none");
        QVERIFY(info != nullptr);
        QCOMPARE(info->severity, Severity::Info);
        const auto other = open(folder, textOf({.step = pad + part}));
        const Diagnostic* const warning = find(**other, "a pad names a component that the step does not have");
        QVERIFY(warning != nullptr);
        QCOMPARE(warning->severity, Severity::Warning);
    }
    void aMessageNamesThePlaceAndTheRestIsShown() {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, message);
        const QTemporaryDir folder;
        const auto board = open(folder, text.toStdString());
        QVERIFY2(board.ok(), board ? "" : board.error().text.c_str());
        const Diagnostic* const entry = find(**board, message.toStdString());
        QVERIFY2(entry != nullptr, message.constData());
        QCOMPARE(entry->file, std::string("bad.xml"));
        QCOMPARE(entry->line, 2U);
        QVERIFY(hasTheTrack(**board));
    }

    void layersThatAreMissingAreDrawings() {
        const QTemporaryDir folder;
        const auto board = open(folder, textOf({.layers = {}}));
        QVERIFY2(board.ok(), board ? "" : board.error().text.c_str());
        QVERIFY(find(**board, "layer that is not listed") != nullptr);
        QVERIFY(hasTheTrack(**board));
    }

    void documentTypesAreRefusedAndNothingIsExpanded_data() {
        QTest::addColumn<QByteArray>("type");
        QByteArray laughs = "<!DOCTYPE lolz [<!ENTITY a0 'lol'>";
        for (int i = 1; i < 30; ++i) {
            const QByteArray before = "&a" + QByteArray::number(i - 1) + ";";
            laughs += "<!ENTITY a" + QByteArray::number(i) + " '" + before.repeated(10) + "'>";
        }
        QTest::newRow("ten to the thirtieth laughs") << laughs + "]>";
        QTest::newRow("the machine's files") << QByteArray("<!DOCTYPE x [<!ENTITY f SYSTEM 'file:///etc/passwd'>]>");
        QTest::newRow("the network") << QByteArray("<!DOCTYPE x SYSTEM 'http://localhost/x.dtd'>");
    }
    void documentTypesAreRefusedAndNothingIsExpanded() {
        QFETCH(QByteArray, type);
        const QTemporaryDir folder;
        const auto board = open(folder, "<?xml version='1.0'?>\n" + type.toStdString() + "\n" + textOf({}));
        QVERIFY(!board);
        QCOMPARE(board.error().code, base::ErrorCode::BadInput);
        QVERIFY2(board.error().text.find("bad.xml: line 2: the file has a document type") != std::string::npos,
                 board.error().text.c_str());
    }

    void entitiesThatNobodyDeclaredStayAsWritten() {
        const QTemporaryDir folder;
        const auto board =
            open(folder, textOf({.step = "<LayerFeature layerRef='B'><Set net='&a9;&lt;'><Hole diameter='1' x='2' "
                                         "y='2' platingStatus='VIA'/></Set></LayerFeature>"}));
        QVERIFY(board.ok());
        QVERIFY(std::ranges::any_of((*board)->nets, [](const Net& net) { return net.name == "&a9;<"; }));
    }
};

QTEST_APPLESS_MAIN(IpcBadInputTest)
#include "ipc_bad_input_test.moc"
