#include "ui/workspace/workspace.h"

#include <QLocale>
#include <algorithm>
#include <numeric>
#include <utility>

#include "model/board/copies.h"
#include "model/board/diagnostic_facts.h"
#include "ui/common/paths.h"
#include "ui/common/texts.h"
#include "ui/common/trouble_text.h"

namespace ui {

namespace {

QString timeText(double seconds) {
    return seconds < 1.0 ? Workspace::tr("%1 ms").arg(qRound(seconds * 1000.0))
                         : Workspace::tr("%1 s").arg(QLocale().toString(seconds, 'f', 1));
}

std::size_t countOf(const LoadedBoard& board, model::Severity severity) {
    return board.document->diagnostics.count(severity) + board.model->diagnostics.count(severity);
}

/// Those of the job, without what we add (board body, bodies of components, solder mask).
std::size_t layersOfJob(const model::Document& board) {
    return static_cast<std::size_t>(std::ranges::count(board.layers, false, &model::Layer::isSynthetic));
}

/// The same board of the same file, whatever that held each time.
bool isSameFile(const LoadedBoard& a, const LoadedBoard& b) {
    return a.request.path == b.request.path && a.request.member == b.request.member && a.format == b.format;
}

std::size_t elementsOfJob(const model::Document& board) {
    const auto counts = board.elementCounts();
    return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

/// The first thing in the job that is not on the board as it should be, and how many more there are.
QStringList lossesOf(const LoadedBoard& board) {
    const model::Diagnostic* first = model::firstError(board.document->diagnostics);
    if (first == nullptr) {
        return {};
    }
    const std::size_t errors = board.document->diagnostics.count(model::Severity::Error);
    const QString place =
        first->file.empty() ? QString() : QStringLiteral(" (%1)").arg(QString::fromStdString(model::placeOf(*first)));
    const QString loss = Workspace::tr("Not all of %1 could be read. %2%3.")
                             .arg(displayName(board.request.path), QString::fromStdString(first->text), place);
    return {errors == 1 ? loss : loss + ' ' + Workspace::tr("Messages lists %L1 more errors.").arg(errors - 1)};
}

QString counted(std::size_t count, const QString& one, const QString& many) {
    return (count == 1 ? one : many).arg(QLocale().toString(static_cast<qulonglong>(count)));
}

/// A panel draws little itself: ", 3 copies of PCB1 with 7,049 each". Nothing for a board without copies.
QString copiesText(const model::StepTree& tree) {
    constexpr std::size_t kMostNamed = 2;
    std::vector<std::size_t> times(tree.steps.size());
    for (const model::StepCopy& copy : tree.copies) {
        ++times[copy.step];
    }
    QString text;
    std::size_t elements = 0;
    for (std::size_t step = 1; step < tree.steps.size(); ++step) {
        const std::size_t each = elementsOfJob(*tree.steps[step]);
        elements += times[step] * each;
        text += ", " + counted(times[step], Workspace::tr("%1 copy"), Workspace::tr("%1 copies")) + ' ' +
                Workspace::tr("of %1 with %2")
                    .arg(QString::fromStdString(tree.steps[step]->job.step),
                         QLocale().toString(static_cast<qulonglong>(each))) +
                (times[step] > 1 ? Workspace::tr(" each") : QString());
    }
    return tree.steps.size() <= 1 + kMostNamed ? text
                                               : Workspace::tr(", copies of %1 steps with %2 in all")
                                                     .arg(tree.steps.size() - 1)
                                                     .arg(QLocale().toString(static_cast<qulonglong>(elements)));
}

/// "Opened board.tgz: 24 layers, 141,000 elements, 3 warnings, in 1.2 s"
QString summaryOf(const LoadedBoard& board, const model::StepTree& tree) {
    return Workspace::tr("Opened %1: %2, %3, %4, in %5")
        .arg(displayName(board.request.path),
             counted(layersOfJob(*board.document), Workspace::tr("%1 layer"), Workspace::tr("%1 layers")),
             counted(elementsOfJob(*board.document), Workspace::tr("%1 element"), Workspace::tr("%1 elements")) +
                 copiesText(tree),
             troubleText(countOf(board, model::Severity::Error), countOf(board, model::Severity::Warning)),
             timeText(board.seconds));
}

}  // namespace

Workspace::Workspace(Loader::Work work, QObject* parent)
    : QObject(parent),
      m_selection(this),
      m_history(this),
      m_files(this),
      m_loader(afterWriting(std::move(work)), this) {
    connect(&m_loader, &Loader::loaded, this, &Workspace::take);
    connect(&m_loader, &Loader::started, this, &Workspace::openingBegan);
    connect(&m_loader, &Loader::asked, this, &Workspace::formsFound);
    connect(&m_loader, &Loader::failed, this, [this](const model::OpenRequest& request, const QString& reason) {
        reportError(tr("%1 was not opened. %2").arg(displayName(request.path), reason));
    });
    connect(&m_loader, &Loader::cancelled, this, [this](const model::OpenRequest& request) {
        report(tr("Stopped opening %1").arg(displayName(request.path)));
    });
    watch(m_loader.background(), [this] { return displayName(m_loader.request().path); });
}

/// Sessions and layer maps are among what is read.
Loader::Work Workspace::afterWriting(Loader::Work work) {
    return [this, work = std::move(work)](const model::OpenRequest& request, base::Progress& progress) {
        m_files.await();
        return work(request, progress);
    };
}

void Workspace::open(model::OpenRequest request) {
    stopWorkOnBoard();
    m_asOpeningBegan = m_board ? std::optional(m_board->thicknesses) : std::nullopt;
    m_loader.open(std::move(request));
}

/// What was begun while the next board was read, too, is about the one that goes.
void Workspace::stopWorkOnBoard() {
    for (const Work& work : m_works) {
        if (!work.file) {
            work.background->cancel();
        }
    }
}

QString Workspace::boardFolder() const {
    const QString board =
        m_board ? QDir::cleanPath(QFileInfo(fromPath(m_board->request.path)).absoluteFilePath()) : QString();
    const QFileInfo folder(QFileInfo(board).absolutePath());
    return m_board && folder.isWritable() ? folder.filePath() : QDir::homePath();
}

void Workspace::reload(const std::function<void(model::OpenRequest&)>& change) {
    model::OpenRequest request = model::reloadRequest(*m_board);
    if (change) {
        change(request);
    }
    open(std::move(request));
}

/// The file was read before they were set, or could not be written.
std::optional<Workspace::Restack> Workspace::laterThicknesses(const LoadedBoard& next) const {
    const bool isLater = m_board && isSameFile(*m_board, next) &&
                         (!m_board->areThicknessesSaved || m_board->thicknesses != m_asOpeningBegan);
    return isLater ? std::optional(Restack{m_board->thicknesses, m_board->areThicknessesSaved}) : std::nullopt;
}

void Workspace::take(const LoadedBoard& board) {
    m_files.report();  // what of the board before is in its file
    stopWorkOnBoard();
    const std::optional<Restack> later = laterThicknesses(board);
    if (m_board) {
        emit boardLeaves(board);
    }
    std::optional<LoadedBoard> before = std::exchange(m_board, board);
    const bool wasUndoable = before && isSameFile(*before, board) && m_history.canUndo();
    m_history.clear();
    m_currentLayer = {};
    emit boardRead(*m_board);
    emit boardShown(*m_board);
    m_selection.setBoard(board.document);
    emit boardOpened(*m_board);
    emit sessionRestored(*m_board);
    if (later) {
        restack(model::session::applyThicknesses(m_board->document, later->thicknesses.all()), later->thicknesses,
                later->areSaved);
    }
    if (const QStringList troubles = lossesOf(board) + textsOf(board.notes); !troubles.isEmpty()) {
        reportError(troubles.join('\n'));
    }
    report((wasUndoable ? tr("Undo begins anew. ") : QString()) + summaryOf(*m_board, m_selection.tree()));
    if (before) {
        m_freeing.start([before = std::move(before)](base::Progress&) mutable { before.reset(); }, "");
    }
}

void Workspace::restack(std::shared_ptr<const model::Document> document, model::SetThicknesses thicknesses,
                        bool areSaved) {
    m_board->document = std::move(document);
    m_board->thicknesses = std::move(thicknesses);
    m_board->areThicknessesSaved = areSaved;
    if (m_board->index) {
        m_board->index = model::withHeights(*m_board->index, m_board->document);
    }
    emit restacked(*m_board);
}

void Workspace::setUnit(LengthUnit unit) {
    m_unit = unit;
    emit unitChanged(unit);
    const QString names[] = {tr("millimetres"), tr("mils"), tr("inches")};  // in the order of LengthUnit
    report(tr("Lengths are in %1").arg(names[static_cast<std::size_t>(unit)]));
}

void Workspace::setCurrentLayer(model::LayerId layer) {
    if (layer != m_currentLayer) {
        m_currentLayer = layer;
        emit currentLayerChanged(layer);
    }
}

void Workspace::reportSaved(const base::Status& saved, const QString& path) {
    saved ? report(tr("Saved %1").arg(path)) : reportError(QString::fromStdString(saved.error().text));
}

void Workspace::watch(Background& work, std::function<QString()> name, std::function<QString()> file) {
    m_works.push_back({&work, std::move(name), std::move(file)});
    const auto isShown = [this, &work] { return isWorking() && firstRunning()->background == &work; };
    connect(&work, &Background::started, this, [this, isShown] {
        if (isShown()) {
            emit workBegan(firstRunning()->name());
        }
    });
    connect(&work, &Background::progressed, this, [this, isShown](const QString& phase, double fraction) {
        if (isShown()) {
            emit workProgressed(phase, fraction);
        }
    });
    connect(&work, &Background::finished, this, &Workspace::onEnded);
    connect(&work, &Background::cancelled, this, &Workspace::onEnded);
}

void Workspace::onEnded() {
    if (const Work* left = firstRunning()) {
        emit workBegan(left->name());
    } else {
        emit idle();
    }
}

const Workspace::Work* Workspace::firstRunning() const {
    const auto running = std::ranges::find_if(m_works, [](const Work& work) { return work.background->isRunning(); });
    return running != m_works.end() ? &*running : nullptr;
}

bool Workspace::cancelWork() {
    const Work* running = firstRunning();
    if (running == nullptr) {
        return false;
    }
    report(tr("Stopped"));  // whoever works may know more
    running->background->cancel();
    return true;
}

QString Workspace::fileAtWork() const {
    const auto isWriting = [](const Work& work) {
        return work.file && work.background->isRunning() && !work.file().isEmpty();
    };
    const auto writing = std::ranges::find_if(m_works, isWriting);
    return writing != m_works.end() ? writing->file() : QString();
}

}  // namespace ui
