#include "ui/export/export_dialog.h"

#include <QAbstractButton>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileInfo>
#include <QFormLayout>
#include <QGroupBox>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardItemModel>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "ui/common/first_size.h"
#include "ui/export/export_layers.h"
#include "ui/export/export_nets.h"
#include "ui/export/export_path.h"

namespace ui {

namespace {

using model::ExportFormat;
using model::ExportRequest;

/// What is on or off, and which formats know it.
struct Option {
    const char* name;  ///< of its box, and in the settings
    const char* text;
    const char* tip;
    bool ExportFormat::*isKnown;
    bool& (*of)(ExportRequest& request);
};
constexpr Option kOptions[] = {
    {"outerOnly", QT_TRANSLATE_NOOP("ui::ExportDialog", "&Outside only"),
     QT_TRANSLATE_NOOP("ui::ExportDialog",
                       "What a mechanical design needs: the substrate and the bodies of components; of outer copper "
                       "layers that are named also the solder pads"),
     &ExportFormat::isSolid, [](ExportRequest& request) -> bool& { return request.choice.isOuterOnly; }},
    {"merge", QT_TRANSLATE_NOOP("ui::ExportDialog", "&Merge touching copper"),
     QT_TRANSLATE_NOOP("ui::ExportDialog", "Touching copper of one net and layer becomes one solid"),
     &ExportFormat::isSolid, [](ExportRequest& request) -> bool& { return request.choice.isMerged; }},
    {"fitArcs", QT_TRANSLATE_NOOP("ui::ExportDialog", "&Arcs instead of chords"),
     QT_TRANSLATE_NOOP(
         "ui::ExportDialog",
         "Runs of chords become arcs, where those are within 5 µm: pours that were drawn with arcs become "
         "small"),
     &ExportFormat::isSolid, [](ExportRequest& request) -> bool& { return request.choice.hasFittedArcs; }},
    {"onePart", QT_TRANSLATE_NOOP("ui::ExportDialog", "One &part"),
     QT_TRANSLATE_NOOP("ui::ExportDialog", "One product with all solids instead of a tree of layers and nets"),
     &ExportFormat::isTree, [](ExportRequest& request) -> bool& { return request.choice.isOnePart; }},
    {"asDesigned", QT_TRANSLATE_NOOP("ui::ExportDialog", "As &designed"),
     QT_TRANSLATE_NOOP("ui::ExportDialog", "With what the fabricator mills away beyond the board outline"),
     &ExportFormat::isSolid, [](ExportRequest& request) -> bool& { return request.choice.isAsDesigned; }},
    {"writtenOut", QT_TRANSLATE_NOOP("ui::ExportDialog", "&Written out"),
     QT_TRANSLATE_NOOP(
         "ui::ExportDialog",
         "Every track, pad and barrel is written instead of one placed often: larger, for programs that do not "
         "read placed shapes"),
     &ExportFormat::isStep, [](ExportRequest& request) -> bool& { return request.isWrittenOut; }},
    {"polylines", QT_TRANSLATE_NOOP("ui::ExportDialog", "Po&lylines"),
     QT_TRANSLATE_NOOP(
         "ui::ExportDialog",
         "Chords around a bend become one edge with one wall: the same solids in a much smaller file, for "
         "programs that take walls with bends"),
     &ExportFormat::isStep, [](ExportRequest& request) -> bool& { return request.hasPolylines; }},
    {"instancing", QT_TRANSLATE_NOOP("ui::ExportDialog", "&Instances"),
     QT_TRANSLATE_NOOP("ui::ExportDialog",
                       "Equal pads of a net as one node, which not all viewers show (EXT_mesh_gpu_instancing)"),
     &ExportFormat::isGlb, [](ExportRequest& request) -> bool& { return request.isInstanced; }},
    {"compress", QT_TRANSLATE_NOOP("ui::ExportDialog", "&Compressed"),
     QT_TRANSLATE_NOOP("ui::ExportDialog", "A third of the size, which not all viewers read (EXT_meshopt_compression)"),
     &ExportFormat::isGlb, [](ExportRequest& request) -> bool& { return request.isCompressed; }},
    {"onePage", QT_TRANSLATE_NOOP("ui::ExportDialog", "All on one pa&ge"),
     QT_TRANSLATE_NOOP("ui::ExportDialog", "All layers on one page, which viewers switch, instead of a page per layer"),
     &ExportFormat::isPdf, [](ExportRequest& request) -> bool& { return request.isOnePage; }},
    {"mirrored", QT_TRANSLATE_NOOP("ui::ExportDialog", "Bottom mirrored"),
     QT_TRANSLATE_NOOP("ui::ExportDialog", "Pages of layers on the bottom of the board as it is seen from below"),
     &ExportFormat::isPdf, [](ExportRequest& request) -> bool& { return request.isMirrored; }},
};

enum Area { Board, Shown };
constexpr int kAreaLetters = 16;  ///< its choice has room for at least so many

QString text(std::string_view utf8) {
    return QString::fromUtf8(utf8.data(), static_cast<qsizetype>(utf8.size()));
}

QComboBox* formatBox() {
    auto* box = new QComboBox;
    box->setObjectName(QStringLiteral("exportFormat"));
    for (const ExportFormat& format : model::exportFormats()) {
        box->addItem(QStringLiteral("%1 – %2").arg(text(format.name), text(format.purpose)));
    }
    return box;
}

/// Takes a comma for a point, as all that lengths are typed into.
class LengthBox : public QDoubleSpinBox {
public:
    QValidator::State validate(QString& text, int& at) const override {
        text.replace(',', '.');
        return QDoubleSpinBox::validate(text, at);
    }
};

/// In the unit of the window, to about a micrometre.
QDoubleSpinBox* minHoleBox(LengthUnit unit) {
    auto* box = new LengthBox;
    box->setObjectName(QStringLiteral("exportMinHole"));
    box->setDecimals(unit == LengthUnit::Millimetre ? 3 : unit == LengthUnit::Mil ? 1 : 4);
    box->setRange(0.0, 10.0 * base::kNmPerMm / nmPer(unit));
    box->setSingleStep(0.1 * base::kNmPerMm / nmPer(unit));
    box->setSuffix(QStringLiteral(" ") + QLatin1String(unitName(unit)));
    box->setSpecialValueText(ExportDialog::tr("None"));
    box->setToolTip(
        ExportDialog::tr("Round holes that are drilled narrower are left out: the substrate is closed there, "
                         "without a barrel"));
    return box;
}

/// Words of several lines, as wide as the dialog and no wider.
QLabel* line(const char* name) {
    auto* label = new QLabel;
    label->setObjectName(QLatin1String(name));
    label->setWordWrap(true);
    label->setTextFormat(Qt::PlainText);
    return label;
}

}  // namespace

ExportDialog::ExportDialog(const ExportSource& source, Settings& settings, QWidget* parent)
    : QDialog(parent),
      m_settings(settings),
      m_window(source.window),
      m_nmPerUnit(nmPer(source.unit)),
      m_format(formatBox()),
      m_path(new ExportPath(settings.lastFolder(source.folder), source.name)),
      m_layers(new ExportLayers(source.layers)),
      m_nets(new ExportNets(source.nets, source.selectedNets)),
      m_area(new QComboBox),
      m_minHole(minHoleBox(source.unit)),
      m_estimate(line("exportEstimate")),
      m_problem(line("exportProblem")) {
    setWindowTitle(tr("Export"));
    auto* halves = new QHBoxLayout;
    halves->addWidget(m_layers, 1);
    halves->addWidget(contents(), 1);
    auto* column = new QVBoxLayout(this);
    column->addWidget(target(source));
    column->addLayout(halves, 1);
    column->addWidget(m_estimate);
    column->addWidget(m_problem);
    column->addWidget(answers());
    m_export->setDefault(true);  // once it is in the dialog, or Enter cancels
    m_format->setFocus();
    resizeToScreen(*this, {920, 520});
    restore();
    listChoices();
    connect(m_format, &QComboBox::currentIndexChanged, this, &ExportDialog::onFormat);
    connect(m_path, &ExportPath::formatTyped, this, &ExportDialog::choose);
    connect(m_path, &ExportPath::changed, this, &ExportDialog::showProblem);
    const auto change = [this] {
        showProblem();
        emit changed();
    };
    connect(m_layers, &ExportLayers::changed, this, change);
    connect(m_nets, &ExportNets::changed, this, change);
    connect(m_area, &QComboBox::currentIndexChanged, this, change);
    connect(m_minHole, &QDoubleSpinBox::valueChanged, this, change);
    for (QCheckBox* option : m_options) {
        connect(option, &QCheckBox::toggled, this, change);
    }
    onFormat();
}

QWidget* ExportDialog::target(const ExportSource& source) {
    m_area->setObjectName(QStringLiteral("exportArea"));
    m_area->addItems({tr("Whole board"), tr("What reaches into the 2D view, uncut")});
    m_area->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);  // small screens cut it
    m_area->setMinimumContentsLength(kAreaLetters);
    m_area->setToolTip(tr(
        "Elements that reach into what the 2D view shows are exported whole, and not cut at its edges; the substrate "
        "stays whole too"));
    qobject_cast<QStandardItemModel*>(m_area->model())->item(Shown)->setEnabled(source.window.has_value());
    auto* box = new QWidget;
    auto* form = new QFormLayout(box);
    form->setContentsMargins({});
    form->addRow(tr("&Format"), m_format);
    form->addRow(tr("F&ile"), m_path);
    return box;
}

QWidget* ExportDialog::contents() {
    auto* box = new QGroupBox(tr("Contents"));
    auto* form = new QFormLayout(box);
    form->addRow(tr("&Nets"), m_nets);
    form->addRow(tr("A&rea"), m_area);
    form->addRow(tr("Leave out &holes below"), m_minHole);
    for (const Option& option : kOptions) {
        auto* check = new QCheckBox(tr(option.text));
        check->setObjectName(QLatin1String(option.name));
        check->setToolTip(tr(option.tip));
        form->addRow(check);
        m_options.push_back(check);
    }
    return box;
}

QWidget* ExportDialog::answers() {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_export = buttons->addButton(tr("&Export"), QDialogButtonBox::AcceptRole);
    QPushButton* picture = buttons->addButton(tr("Picture (PN&G)…"), QDialogButtonBox::ActionRole);
    picture->setToolTip(tr("Save the view as a PNG file instead"));
    picture->setAutoDefault(false);
    connect(picture, &QPushButton::clicked, this, [this] {
        reject();
        emit pictureWanted();
    });
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    return buttons;
}

void ExportDialog::choose(const model::ExportFormat& format) {
    m_format->setCurrentIndex(static_cast<int>(&format - model::exportFormats().data()));
}

const ExportFormat& ExportDialog::format() const {
    return model::exportFormats()[static_cast<std::size_t>(m_format->currentIndex())];
}

ExportRequest ExportDialog::request() const {
    ExportRequest request;
    request.choice.layers = m_layers->layers();
    if (format().isSolid) {
        request.choice.nets = m_nets->nets();
        request.choice.window = m_area->currentIndex() == Shown ? m_window : std::nullopt;
        request.choice.minHole = static_cast<base::Nm>(std::llround(m_minHole->value() * m_nmPerUnit));
    }
    for (std::size_t row = 0; row < m_options.size(); ++row) {
        kOptions[row].of(request) = format().*kOptions[row].isKnown && m_options[row]->isChecked();
    }
    return request;
}

QString ExportDialog::path() const {
    return m_path->path();
}

void ExportDialog::setEstimate(const QString& text) {
    m_estimate->setText(text);
}

void ExportDialog::listChoices() {
    m_choices.push_back({m_area, "currentIndex", int{Board}, &ExportFormat::isSolid});
    m_choices.push_back({m_minHole, "value", 0.0, &ExportFormat::isSolid});
    for (std::size_t row = 0; row < m_options.size(); ++row) {
        m_choices.push_back({m_options[row], "checked", false, kOptions[row].isKnown});
    }
}

QVariant ExportDialog::chosen(const QWidget* widget) const {
    const auto choice = std::ranges::find_if(m_choices, [&](const Choice& each) { return each.widget == widget; });
    return widget->isEnabled() ? widget->property(choice->property) : choice->chosen;
}

void ExportDialog::onFormat() {
    m_path->setFormat(format());
    m_nets->setApplied(format().isSolid);
    for (Choice& choice : m_choices) {
        choice.chosen = chosen(choice.widget);
        choice.widget->setEnabled(format().*choice.isKnown);
        choice.widget->setProperty(choice.property, choice.widget->isEnabled() ? choice.chosen : choice.none);
    }
    showProblem();
    emit changed();
}

QString ExportDialog::problem() const {
    if (m_layers->layers().empty()) {
        return tr("Choose a layer to export");
    }
    const QString nets = format().isSolid ? m_nets->problem() : QString();
    return nets.isEmpty() ? m_path->problem() : nets;
}

void ExportDialog::showProblem() {
    m_problem->setText(problem());
    m_export->setEnabled(m_problem->text().isEmpty());
}

void ExportDialog::restore() {
    const QString name = m_settings.exportChoice(QStringLiteral("format"), {}).toString();
    for (int i = 0; i < m_format->count(); ++i) {
        if (text(model::exportFormats()[static_cast<std::size_t>(i)].name) == name) {
            m_format->setCurrentIndex(i);
        }
    }
    m_layers->restore(m_settings);
    m_nets->restore(m_settings);
    const bool isShown = m_window && m_settings.exportChoice(QStringLiteral("area"), {}).toInt() == Shown;
    m_area->setCurrentIndex(isShown ? Shown : Board);
    m_minHole->setValue(m_settings.exportChoice(QStringLiteral("minHole"), 0.0).toDouble() / m_nmPerUnit);
    for (QCheckBox* option : m_options) {
        option->setChecked(m_settings.exportChoice(option->objectName(), false).toBool());
    }
}

void ExportDialog::remember() {
    m_settings.setExportChoice(QStringLiteral("format"), text(format().name));
    m_layers->remember(m_settings);
    m_nets->remember(m_settings);
    m_settings.setExportChoice(QStringLiteral("area"), chosen(m_area));
    m_settings.setExportChoice(QStringLiteral("minHole"), chosen(m_minHole).toDouble() * m_nmPerUnit);
    for (const QCheckBox* option : m_options) {
        m_settings.setExportChoice(option->objectName(), chosen(option));
    }
    m_settings.setLastFolder(QFileInfo(path()).path());
}

void ExportDialog::accept() {
    const auto finish = [this] {
        remember();
        QDialog::accept();
    };
    if (!QFileInfo::exists(path())) {
        finish();
        return;
    }
    auto* question = new QMessageBox(QMessageBox::Question, tr("Export"),
                                     tr("%1 exists. Replace it?").arg(QFileInfo(path()).fileName()),
                                     QMessageBox::Yes | QMessageBox::Cancel, this);
    question->setAttribute(Qt::WA_DeleteOnClose);
    question->setDefaultButton(QMessageBox::Cancel);
    question->button(QMessageBox::Yes)->setText(tr("&Replace"));
    connect(question, &QMessageBox::buttonClicked, this, [question, finish](QAbstractButton* button) {
        if (question->standardButton(button) == QMessageBox::Yes) {
            finish();
        }
    });
    question->open();
}

}  // namespace ui
