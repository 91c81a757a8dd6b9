#include "ui/export/export_nets.h"

#include <QComboBox>
#include <QCompleter>
#include <QLineEdit>
#include <QStandardItemModel>
#include <QVBoxLayout>
#include <utility>

#include "model/text/net_names.h"

namespace ui {

namespace {

/// Completes the last of the names between commas.
class LastNameCompleter : public QCompleter {
public:
    using QCompleter::QCompleter;

    [[nodiscard]] QStringList splitPath(const QString& path) const override {
        m_before = path.left(path.lastIndexOf(',') + 1);
        return {path.mid(m_before.size()).trimmed()};
    }
    [[nodiscard]] QString pathFromIndex(const QModelIndex& index) const override {
        return m_before + (m_before.isEmpty() ? "" : " ") + index.data(Qt::EditRole).toString();
    }

private:
    mutable QString m_before;  ///< what is typed before the last name
};

}  // namespace

ExportNets::ExportNets(const std::vector<std::string>& all, std::vector<std::string> selected, QWidget* parent)
    : QWidget(parent), m_selected(std::move(selected)), m_which(new QComboBox), m_names(new QLineEdit) {
    for (const std::string& name : all) {
        m_nets.emplace(QString::fromStdString(name), name);
    }
    for (const std::string& name : all) {
        m_nets.emplace(QString::fromStdString(model::typedName(name)), name);
    }
    const QString one = m_selected.size() == 1 ? QString::fromStdString(model::readableName(m_selected.front())) : "";
    m_which->setObjectName(QStringLiteral("exportNets"));
    m_which->addItems({tr("All nets"),
                       one.isEmpty() ? tr("%L1 nets of the selection").arg(m_selected.size()) : tr("Net %1").arg(one),
                       tr("These nets:")});
    m_which->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_which->setToolTip(tr("Copper of other nets is left out; what is no copper stays"));
    qobject_cast<QStandardItemModel*>(m_which->model())->item(OfSelection)->setEnabled(!m_selected.empty());
    m_names->setObjectName(QStringLiteral("exportNetNames"));
    m_names->setAccessibleName(tr("Names of nets"));
    m_names->setPlaceholderText(tr("Names of nets, between commas"));
    completeNames();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins({});
    column->addWidget(m_which);
    column->addWidget(m_names);
    const auto update = [this] {
        m_names->setVisible(which() == Typed);
        emit changed();
    };
    connect(m_which, &QComboBox::currentIndexChanged, this, update);
    connect(m_names, &QLineEdit::textChanged, this, &ExportNets::changed);
    update();
}

void ExportNets::completeNames() {
    QStringList words;
    for (const auto& [word, net] : m_nets) {
        words += word;
    }
    auto* completer = new LastNameCompleter(words, m_names);
    completer->setCaseSensitivity(Qt::CaseInsensitive);
    completer->setFilterMode(Qt::MatchContains);
    m_names->setCompleter(completer);
}

int ExportNets::which() const {
    return m_which->currentIndex();
}

std::vector<std::string> ExportNets::typed(QString* problem) const {
    const QString text = m_names->text().trimmed();
    if (const auto found = m_nets.find(text); found != m_nets.end()) {
        return {found->second};  // whatever characters it has
    }
    std::vector<std::string> nets;
    for (const QString& part : text.split(',', Qt::SkipEmptyParts)) {
        const auto found = m_nets.find(part.trimmed());
        if (found != m_nets.end()) {
            nets.push_back(found->second);
        } else if (problem != nullptr && problem->isEmpty() && !part.trimmed().isEmpty()) {
            *problem = tr("There is no net %1").arg(part.trimmed());
        }
    }
    if (problem != nullptr && problem->isEmpty() && nets.empty()) {
        *problem = tr("Name the nets to export");
    }
    return nets;
}

std::vector<std::string> ExportNets::nets() const {
    return which() == All ? std::vector<std::string>{} : which() == OfSelection ? m_selected : typed();
}

QString ExportNets::problem() const {
    QString problem;
    if (which() == Typed) {
        (void)typed(&problem);
    }
    return problem;
}

void ExportNets::restore(const Settings& settings) {
    m_names->setText(settings.exportChoice(QStringLiteral("netNames"), {}).toString());
    m_which->setCurrentIndex(settings.exportChoice(QStringLiteral("nets"), All).toInt());
    if ((which() == OfSelection && m_selected.empty()) || which() < 0 || !problem().isEmpty()) {
        m_which->setCurrentIndex(All);
    }
}

void ExportNets::setApplied(bool isApplied) {
    m_chosen = chosen();
    setEnabled(isApplied);
    m_which->setCurrentIndex(isApplied ? m_chosen : All);
}

void ExportNets::remember(Settings& settings) const {
    settings.setExportChoice(QStringLiteral("netNames"), m_names->text());
    settings.setExportChoice(QStringLiteral("nets"), chosen());
}

}  // namespace ui
