// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/RecoverySheet.h"

#include "panels/Theme.h"

#include <QGraphicsOpacityEffect>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QVBoxLayout>

#include <array>

namespace espalier {

namespace {

constexpr QSize kRecoveryPicture(176, 176); // px
constexpr int kTextWidth = 220;             // px
constexpr unsigned kMostRowsShown = 2;      ///< Without scrolling
constexpr int kPeek = 70;                   ///< What shows of the next row, px
constexpr int kRowGap = 18;                 // px
constexpr double kDiscardedOpacity = 0.35;

QString timeText(const QDateTime& time)
{
    const QString clock = QLocale().toString(time.time(), QLocale::ShortFormat);
    const qint64 days = time.date().daysTo(QDate::currentDate());
    if (days == 0)
        return RecoverySheet::tr("today, %1").arg(clock);
    if (days == 1)
        return RecoverySheet::tr("yesterday, %1").arg(clock);
    return QLocale().toString(time, QLocale::ShortFormat);
}

} // namespace

/// One tree: its pictures, its name, and what to do with it.
class RecoveryRow : public QWidget {
    Q_OBJECT

public:
    RecoveryRow(const RecoverableTree& tree, QWidget* parent);

    void showState(RecoverySheet::State state, const QImage& picture, const QString& caption);
    bool isDiscarded() const { return m_discard->isChecked(); }
    QPushButton* bringBack() const { return m_bringBack; }

Q_SIGNALS:
    void bringBackAsked();
    void discardedChanged();

private:
    /// A picture with what is said below it.
    struct Frame {
        QLabel* picture = nullptr;
        QLabel* caption = nullptr;
        QString begin; ///< Of the caption
    };
    Frame makeFrame(QGridLayout& grid, int column, const QString& title, const QDateTime& time);
    static void setCaption(const Frame& frame, const QString& caption);
    void showDiscarded();

    std::array<Frame, 2> m_frames;
    QLabel* m_note;
    QPushButton* m_bringBack;
    QPushButton* m_discard;
    QWidget* m_pictures;
};

RecoveryRow::RecoveryRow(const RecoverableTree& tree, QWidget* parent)
    : QWidget(parent),
      m_note(new QLabel(this)),
      m_bringBack(new QPushButton(tr("Bring Back"), this)),
      m_discard(new QPushButton(tr("Discard"), this)),
      m_pictures(new QWidget(this))
{
    auto* grid = new QGridLayout(m_pictures);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(10);
    grid->setVerticalSpacing(4);
    if (tree.saved)
        m_frames[0] = makeFrame(*grid, 0, tr("In the file"), *tree.saved);
    m_frames[1] = makeFrame(*grid, 1, tr("Can be brought back"), tree.changed);

    auto* name = new QLabel(tree.name, this);
    name->setTextFormat(Qt::PlainText);
    name->setWordWrap(true);
    QFont bold = name->font();
    bold.setBold(true);
    name->setFont(bold);
    auto* place = new QLabel(tree.place, this);
    place->setTextFormat(Qt::PlainText);
    place->setWordWrap(true);
    theme::setTone(*place, theme::Tone::Dim);
    place->setVisible(!tree.place.isEmpty());
    m_note->setTextFormat(Qt::PlainText);
    m_note->setWordWrap(true);
    m_note->setText(tr("It will be deleted when this closes."));
    QSizePolicy keepsRoom = m_note->sizePolicy();
    keepsRoom.setRetainSizeWhenHidden(true);
    m_note->setSizePolicy(keepsRoom);
    for (QPushButton* button : {m_bringBack, m_discard}) {
        button->setMinimumSize(120, theme::kTarget);
        button->setAutoDefault(true);
    }
    m_bringBack->setAccessibleName(tr("Bring back %1").arg(tree.name));
    m_discard->setAccessibleName(tr("Discard %1").arg(tree.name));
    m_discard->setCheckable(true);
    connect(m_bringBack, &QPushButton::clicked, this, &RecoveryRow::bringBackAsked);
    connect(m_discard, &QPushButton::toggled, this, &RecoveryRow::showDiscarded);

    auto* text = new QVBoxLayout;
    text->setSpacing(4);
    text->addWidget(name);
    text->addWidget(place);
    text->addStretch(1);
    text->addWidget(m_note);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(10);
    buttons->addWidget(m_bringBack);
    buttons->addWidget(m_discard);
    buttons->addStretch(1);
    text->addLayout(buttons);
    auto* all = new QHBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->setSpacing(18);
    all->addWidget(m_pictures, 0, Qt::AlignTop);
    all->addLayout(text, 1);
    name->setMinimumWidth(kTextWidth);
    showDiscarded();
}

RecoveryRow::Frame RecoveryRow::makeFrame(QGridLayout& grid, int column, const QString& title,
                                          const QDateTime& time)
{
    Frame frame;
    frame.picture = new QLabel(tr("Drawing…"), m_pictures);
    frame.picture->setAlignment(Qt::AlignCenter);
    frame.picture->setFixedSize(kRecoveryPicture);
    frame.picture->setProperty("picture", true);
    frame.picture->setAccessibleName(title);
    frame.begin = title + QLatin1Char('\n') + timeText(time);
    frame.caption = new QLabel(m_pictures);
    frame.caption->setTextFormat(Qt::PlainText);
    frame.caption->setWordWrap(true);
    frame.caption->setFixedWidth(kRecoveryPicture.width());
    frame.caption->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    theme::setTone(*frame.caption, theme::Tone::Dim);
    setCaption(frame, QStringLiteral(" "));
    grid.addWidget(frame.picture, 0, column);
    grid.addWidget(frame.caption, 1, column, Qt::AlignTop);
    return frame;
}

void RecoveryRow::showState(RecoverySheet::State state, const QImage& picture, const QString& caption)
{
    const Frame& frame = m_frames[state == RecoverySheet::State::Saved ? 0 : 1];
    if (!frame.picture)
        return;
    QPixmap pixmap = QPixmap::fromImage(picture);
    pixmap.setDevicePixelRatio(devicePixelRatioF());
    if (picture.isNull())
        frame.picture->setText(tr("No picture"));
    else
        frame.picture->setPixmap(pixmap);
    setCaption(frame, caption);
}

void RecoveryRow::setCaption(const Frame& frame, const QString& caption)
{
    frame.caption->setText(frame.begin + QLatin1Char('\n') + caption);
    frame.caption->setMinimumHeight(frame.caption->heightForWidth(kRecoveryPicture.width()));
}

void RecoveryRow::showDiscarded()
{
    const bool isDiscarded = m_discard->isChecked();
    m_note->setVisible(isDiscarded);
    m_bringBack->setEnabled(!isDiscarded);
    m_discard->setText(isDiscarded ? tr("Keep") : tr("Discard"));
    QGraphicsOpacityEffect* effect = nullptr;
    if (isDiscarded) {
        effect = new QGraphicsOpacityEffect(m_pictures);
        effect->setOpacity(kDiscardedOpacity);
    }
    m_pictures->setGraphicsEffect(effect);
    Q_EMIT discardedChanged();
}

RecoverySheet::RecoverySheet(const std::vector<RecoverableTree>& trees, QWidget* parent)
    : QDialog(parent), m_end(new QPushButton(this))
{
    setWindowTitle(tr("Bring Trees Back"));
    auto* text = new QLabel(tr("Espalier ended before this was saved. What you leave here is offered again "
                               "at the next start."),
                            this);
    text->setTextFormat(Qt::PlainText);
    text->setWordWrap(true);

    auto* list = new QWidget;
    auto* rows = new QVBoxLayout(list);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(kRowGap);
    for (std::size_t i = 0; i < trees.size(); ++i) {
        auto* row = new RecoveryRow(trees[i], list);
        row->setObjectName(QStringLiteral("recovery%1").arg(i));
        rows->addWidget(row);
        m_rows.push_back(row);
        connect(row, &RecoveryRow::bringBackAsked, this, [this, i] {
            m_broughtBack = i;
            accept();
        });
        connect(row, &RecoveryRow::discardedChanged, this, &RecoverySheet::showEnd);
    }
    rows->addStretch(1);
    auto* scroll = new QScrollArea(this);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(list);
    m_scroll = scroll;

    m_end->setMinimumSize(120, theme::kTarget);
    m_end->setAutoDefault(true);
    m_end->setObjectName(QStringLiteral("recoveryEnd"));
    // Escape leaves everything as it is.
    connect(m_end, &QPushButton::clicked, this, [this] { done(marked().empty() ? Rejected : Accepted); });
    auto* last = new QHBoxLayout;
    last->addStretch(1);
    last->addWidget(m_end);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(26, 20, 26, 20);
    all->setSpacing(18);
    all->addWidget(text);
    all->addWidget(scroll, 1);
    all->addLayout(last);
    m_rows.front()->bringBack()->setDefault(true);
    m_rows.front()->bringBack()->setFocus();
    showEnd();
    fit();
}

/// Gives the first rows the room that they need now.
void RecoverySheet::fit()
{
    QWidget& list = *m_scroll->widget();
    int height = 0;
    for (std::size_t i = 0; i < m_rows.size() && i < kMostRowsShown; ++i) {
        m_rows[i]->layout()->activate();
        height += m_rows[i]->sizeHint().height() + (i > 0 ? kRowGap : 0);
    }
    list.layout()->activate();
    const bool hasMore = m_rows.size() > kMostRowsShown;
    const int width = list.sizeHint().width() + m_scroll->verticalScrollBar()->sizeHint().width() + 6;
    m_scroll->setMinimumSize(width, height + (hasMore ? kRowGap + kPeek : 0));
}

void RecoverySheet::showState(std::size_t tree, State state, const QImage& picture, const QString& caption)
{
    m_rows.at(tree)->showState(state, picture, caption);
    fit();
}

QSize RecoverySheet::pictureSize() const
{
    return kRecoveryPicture;
}

std::vector<std::size_t> RecoverySheet::discarded() const
{
    return result() == Accepted ? marked() : std::vector<std::size_t>();
}

std::vector<std::size_t> RecoverySheet::marked() const
{
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        if (m_rows[i]->isDiscarded())
            indices.push_back(i);
    }
    return indices;
}

void RecoverySheet::showEnd()
{
    m_end->setText(marked().empty() ? tr("Later") : tr("Done"));
}

} // namespace espalier

#include "RecoverySheet.moc"
