// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/architecture/ArchitecturePanel.h"

#include "model/growth/VigourSpecies.h"
#include "panels/ParameterRow.h"
#include "panels/Sideways.h"
#include "panels/Theme.h"
#include "panels/architecture/BranchingDiagram.h"
#include "panels/architecture/DirectionDiagram.h"
#include "panels/architecture/GravimorphismDiagram.h"
#include "panels/architecture/PerceptionDiagram.h"
#include "panels/architecture/TropismDiagram.h"
#include "panels/architecture/ValueField.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QScrollBar>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <span>

namespace espalier {

namespace {

// px
constexpr int kLeastCard = 166;
constexpr int kMostCard = 330;
constexpr int kDiagramWidth = 162;
constexpr int kDiagramSpacing = 10;
constexpr int kPanelMargin = 14;
// In a window without room for more.
constexpr int kTightSpacing = 5;
constexpr int kTightMargin = 8;
constexpr int kLeastDiagram = 150;
constexpr int kMostDiagram = 290;
/// The largest share of the window's height for the panel; the tree keeps the rest.
constexpr double kMostHeight = 0.2;

QLabel* captionLabel(const QString& text, QWidget* parent)
{
    auto* label = new QLabel(text, parent);
    label->setAlignment(Qt::AlignTop | Qt::AlignRight);
    label->setFixedHeight(24);
    theme::setTone(*label, theme::Tone::Dim);
    return label;
}

/// A widget of controls side by side; returns its layout.
QHBoxLayout* controlsLine(QWidget& widget)
{
    auto* line = new QHBoxLayout(&widget);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(kDiagramSpacing);
    return line;
}

} // namespace

ArchitecturePanel::ArchitecturePanel(TreeDocument& document, QWidget* parent)
    : Bar(parent),
      m_editor(document),
      m_moreButton(new BarButton(BarButton::Look::Tab)),
      m_treeSketch(new QWidget),
      m_more(new QWidget),
      m_vigour(new QWidget)
{
    setAccessibleName(tr("Architecture"));
    auto* content = new QWidget;
    auto* line = new QHBoxLayout(content);
    line->setContentsMargins(kPanelMargin, 14, kPanelMargin, 8);
    line->setSpacing(kDiagramSpacing);
    for (QWidget* part : {m_treeSketch, m_vigour, m_more})
        part->setParent(content);
    QHBoxLayout* treeSketchLine = controlsLine(*m_treeSketch);
    QHBoxLayout* moreLine = controlsLine(*m_more);
    QHBoxLayout* vigourLine = controlsLine(*m_vigour);
    m_more->hide();

    using enum ParameterSection::Look;
    for (const ParameterSection& section : parameterSections()) {
        if (section.sheet != ParameterSheet::Architecture)
            continue;
        addSection(section, section.look == Model    ? *line
                            : section.look == More   ? *moreLine
                            : section.look == Vigour ? *vigourLine
                                                     : *treeSketchLine);
    }
    makeSpecies(*line->itemAt(0)->widget());
    addMoreButton(*treeSketchLine->itemAt(treeSketchLine->count() - 1)->widget());
    line->addWidget(m_treeSketch);
    line->addWidget(m_more);
    line->addWidget(m_vigour);
    line->addStretch();
    connect(&m_editor, &ParameterEditor::shownChanged, this, &ArchitecturePanel::follow);

    m_sideways = new Sideways(content, this);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(1, 1, 1, 1);
    whole->addWidget(m_sideways);
    follow();
}

void ArchitecturePanel::addSection(const ParameterSection& section, QHBoxLayout& line)
{
    if (section.look != ParameterSection::Look::Model)
        line.addWidget(barSeparator(Qt::Vertical, line.parentWidget()));
    line.addWidget(section.look == ParameterSection::Look::Diagram
                       ? makeCard(section, line.parentWidget())
                       : makeColumn(section, line.parentWidget()));
}

void ArchitecturePanel::addMoreButton(QWidget& column)
{
    m_moreButton->setText(tr("More ›"));
    m_moreButton->setObjectName(QStringLiteral("moreGrowth"));
    m_moreButton->setCheckable(true);
    m_moreButton->setToolTip(tr("Everything else that steers growth: shoots, shade, room to grow"));
    connect(m_moreButton, &QToolButton::toggled, this, &ArchitecturePanel::showMore);
    auto* lines = qobject_cast<QVBoxLayout*>(column.layout());
    lines->insertWidget(lines->count() - 1, m_moreButton, 0, Qt::AlignLeft);
}

void ArchitecturePanel::makeSpecies(QWidget& column)
{
    m_species = new QComboBox(&column);
    m_species->setObjectName(QStringLiteral("species"));
    m_species->setAccessibleName(tr("Species"));
    m_species->setToolTip(tr("Set all parameters of the vigour model to those of a species."));
    m_species->setFocusPolicy(Qt::StrongFocus);
    m_species->addItem(tr("No species"));
    for (const VigourSpecies& species : vigourSpecies())
        m_species->addItem(parameterTr(species.name));
    connect(m_species, &QComboBox::activated, this, &ArchitecturePanel::chooseSpecies);
    auto* lines = qobject_cast<QVBoxLayout*>(column.layout());
    lines->insertWidget(lines->count() - 1, m_species);
}

void ArchitecturePanel::chooseSpecies(int item)
{
    if (item <= 0) { // that is no choice
        follow();
        return;
    }
    const VigourSpecies& species = vigourSpecies()[static_cast<std::size_t>(item - 1)];
    m_editor.begin();
    TreeParameters parameters = m_editor.shown();
    parameters.vigour = species.parameters;
    m_editor.show(parameters);
    m_editor.finish(tr("Species"));
}

/// Shows the controls of the model in force.
void ArchitecturePanel::follow()
{
    const TreeParameters& shown = m_editor.shown();
    const auto found = std::ranges::find(vigourSpecies(), shown.vigour, &VigourSpecies::parameters) -
                       vigourSpecies().begin();
    const bool isSpecies = found < std::ssize(vigourSpecies());
    m_species->setCurrentIndex(isSpecies ? static_cast<int>(found) + 1 : 0);
    const bool isVigour = shown.growth.model == GrowthModelKind::Vigour;
    if (isVigour == !m_vigour->isHidden() && isVigour == m_treeSketch->isHidden())
        return;
    m_species->setVisible(isVigour);
    m_vigour->setVisible(isVigour);
    m_treeSketch->setVisible(!isVigour);
    m_more->setVisible(!isVigour && isMoreShown());
    Q_EMIT sizeWanted();
}

Diagram* ArchitecturePanel::makeDiagram(const ParameterSection& section, QWidget* parent)
{
    const std::string_view key = section.parameters.front().key;
    if (key == "growth.setPointAngle")
        return m_schematic = new TropismDiagram(m_editor, parent);
    if (key == "growth.ellipseVertical")
        return new GravimorphismDiagram(m_editor, parent);
    if (key == "growth.branchingAngle")
        return new BranchingDiagram(m_editor, parent);
    if (key == "growth.axisWeight")
        return new DirectionDiagram(m_editor, parent);
    return new PerceptionDiagram(m_editor, parent);
}

QWidget* ArchitecturePanel::makeCard(const ParameterSection& section, QWidget* parent)
{
    auto* card = new QWidget(parent);
    card->setAccessibleName(parameterTr(section.title));
    m_cards.push_back(card);
    Diagram* diagram = makeDiagram(section, card);
    m_diagrams.push_back(diagram);
    diagram->setAccessibleName(parameterTr(section.title));
    QStringList explanations;
    QStringList tips;
    for (const ParameterText& text : section.parameters) {
        explanations.append(explanation(text));
        tips.append(parameterTr(text.tip));
    }
    diagram->setAccessibleDescription(tips.join(QLatin1Char(' ')));
    diagram->setToolTip(explanations.join(QStringLiteral("<br>")));
    diagram->setWhatsThis(diagram->toolTip());

    auto* lines = new QVBoxLayout(card);
    lines->setContentsMargins(0, 0, 0, 0);
    lines->setSpacing(0);
    auto* heading = new QHBoxLayout;
    heading->addWidget(barHeading(parameterTr(section.title), card));
    QLabel* caption = captionLabel(diagram->caption(), card);
    heading->addWidget(caption, 1);
    lines->addLayout(heading);
    lines->addWidget(diagram, 1);
    auto* values = new QHBoxLayout;
    values->setSpacing(4);
    for (const ParameterText& text : section.parameters) {
        m_fields.push_back(new ValueField(m_editor, text.key, card));
        values->addWidget(m_fields.back());
    }
    values->addStretch(1);
    lines->addLayout(values);
    connect(&m_editor, &ParameterEditor::shownChanged, caption,
            [caption, diagram] { caption->setText(diagram->caption()); });
    return card;
}

QWidget* ArchitecturePanel::makeColumn(const ParameterSection& section, QWidget* parent)
{
    auto* column = new QWidget(parent);
    column->setFixedWidth(kDiagramWidth);
    auto* lines = new QVBoxLayout(column);
    lines->setContentsMargins(0, 0, 0, 0);
    lines->setSpacing(3);
    lines->addWidget(barHeading(parameterTr(section.title), column));
    for (const ParameterText& text : section.parameters) {
        m_rows.push_back(new ParameterRow(m_editor, text, column));
        if (std::string_view(text.label) == section.title)
            m_rows.back()->hideLabel();
        lines->addWidget(m_rows.back());
    }
    lines->addStretch(1);
    return column;
}

void ArchitecturePanel::fit(const QSize& room)
{
    // The columns of the model, of vigour and of habit, and the separators beside them.
    const int columns = 3 * kDiagramWidth + 3 * (2 * kDiagramSpacing + 1);
    const int more = isMoreShown() ? m_more->sizeHint().width() + kDiagramSpacing : 0;
    const int count = isMoreShown() ? 1 : static_cast<int>(m_cards.size());
    const int wide = (room.width() - 2 * kPanelMargin - columns - more) / count - 2 * kDiagramSpacing - 1;
    const int card = std::clamp(wide, kLeastCard, kMostCard);
    const int tall = std::clamp(std::min(card * 5 / 6, static_cast<int>(kMostHeight * room.height())),
                                kLeastDiagram, kMostDiagram);
    for (QWidget* one : m_cards)
        one->setFixedWidth(card);
    for (Diagram* diagram : m_diagrams)
        diagram->setFixedHeight(tall);
    setSpacing(kDiagramSpacing, kPanelMargin);
    if (m_sideways->sizeHint().width() + 2 > room.width())
        setSpacing(kTightSpacing, kTightMargin);
    const QSize wanted = m_sideways->sizeHint() + QSize(2, 2);
    resize(std::min(wanted.width(), room.width()), wanted.height());
}

/// Sets the room between the parts, and at both ends, px.
void ArchitecturePanel::setSpacing(int spacing, int margin)
{
    QWidget* content = m_sideways->widget();
    content->layout()->setContentsMargins(margin, 14, margin, 8);
    content->layout()->setSpacing(spacing);
    for (const QWidget* part : {m_treeSketch, m_vigour, m_more})
        part->layout()->setSpacing(spacing);
    // The sizes of what the panel shows next are needed now, from the inside outward.
    const QList<QWidget*> widgets = content->findChildren<QWidget*>();
    for (auto widget = widgets.rbegin(); widget != widgets.rend(); ++widget) {
        if (QLayout* layout = (*widget)->layout())
            layout->activate();
        (*widget)->updateGeometry();
    }
    content->layout()->activate();
}

ParameterRow* ArchitecturePanel::row(std::string_view key) const
{
    const auto found =
        std::ranges::find_if(m_rows, [&](const ParameterRow* row) { return key == row->key(); });
    return found == m_rows.end() ? nullptr : *found;
}

ValueField* ArchitecturePanel::field(std::string_view key) const
{
    const auto found =
        std::ranges::find_if(m_fields, [&](const ValueField* field) { return key == field->key(); });
    return found == m_fields.end() ? nullptr : *found;
}

bool ArchitecturePanel::isMoreShown() const
{
    return m_moreButton->isChecked();
}

void ArchitecturePanel::showMore(bool shown)
{
    m_moreButton->setChecked(shown);
    m_moreButton->setText(shown ? tr("‹ Less") : tr("More ›"));
    m_more->setVisible(shown);
    // The rest takes the place of the drawings but the first, the schematic tree, which shows what it does.
    const QLayout* line = m_treeSketch->layout();
    for (QWidget* card : std::span(m_cards).subspan(1)) {
        card->setVisible(!shown);
        line->itemAt(line->indexOf(card) - 1)->widget()->setVisible(!shown);
    }
    Q_EMIT sizeWanted();
    // After all widgets have their places.
    if (shown)
        QTimer::singleShot(0, this, [this] { m_sideways->ensureWidgetVisible(m_more, kPanelMargin); });
}

} // namespace espalier
