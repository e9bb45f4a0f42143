// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/CommandLine.h"

#include "model/io/export/ExportFormats.h"

#include <QCommandLineParser>
#include <QCoreApplication>
#include <QFileInfo>
#include <QRegularExpression>

#include <algorithm>
#include <vector>

namespace espalier {

namespace {

using Verb = CommandLine::Verb;

struct CommandLineText {
    Q_DECLARE_TR_FUNCTIONS(CommandLine)
};

Error usage(const QString& message)
{
    return {Error::Kind::Input, message};
}

constexpr int kMaxPictureEdge = 16384;
constexpr int kMaxThreads = 1024;

Result<QSize> parseSize(const QString& text)
{
    static const QRegularExpression pattern(QStringLiteral("^([0-9]{1,5})x([0-9]{1,5})$"));
    const QRegularExpressionMatch match = pattern.match(text);
    const QSize size(match.captured(1).toInt(), match.captured(2).toInt());
    if (!match.hasMatch() || size.width() < 1 || size.height() < 1 || size.width() > kMaxPictureEdge ||
        size.height() > kMaxPictureEdge)
        return usage(CommandLineText::tr("--size needs WIDTHxHEIGHT of up to %1 pixels each, not \"%2\"")
                         .arg(kMaxPictureEdge)
                         .arg(text));
    return size;
}

/// An option, and the function that puts its value into the command line.
struct Option {
    const char* name;
    const char* verbs; ///< The verbs that accept it, between blanks
    Result<void> (*take)(CommandLine&, const QString& value);
    bool isFlag = false; ///< It has no value

    /// The name with its dashes.
    QString shown() const { return dashed(QString::fromLatin1(name)); }
    static QString dashed(const QString& name)
    {
        return (name.size() == 1 ? QStringLiteral("-") : QStringLiteral("--")) + name;
    }
};

constexpr Option kOptions[] = {
    {"o", " replay import sketch export ",
     [](CommandLine& line, const QString& value) -> Result<void> {
         if (QFileInfo(value).suffix().toLower() != QLatin1String("espalier") && !exportFormatOf(value)) {
             return usage(CommandLineText::tr(
                              "%1: the suffix of an output says its format, and is one of .espalier .%2")
                              .arg(value, exportSuffixes().join(QLatin1String(" ."))));
         }
         line.outputs.append(value);
         return {};
     }},
    {"png", " replay sketch render ",
     [](CommandLine& line, const QString& value) -> Result<void> {
         line.picture = value;
         return {};
     }},
    {"size", " replay sketch render ",
     [](CommandLine& line, const QString& value) -> Result<void> {
         const Result<QSize> size = parseSize(value);
         if (!size)
             return size.error();
         line.size = *size;
         return {};
     }},
    {"camera", " replay sketch render ",
     [](CommandLine& line, const QString& value) -> Result<void> {
         static const QStringList known{QStringLiteral("front"), QStringLiteral("side"),
                                        QStringLiteral("top"), QStringLiteral("three-quarter")};
         if (!known.contains(value))
             return usage(CommandLineText::tr("--camera needs front, side, top or three-quarter, not \"%1\"")
                              .arg(value));
         line.camera = value;
         return {};
     }},
    {"transparent", " replay sketch render ",
     [](CommandLine& line, const QString&) -> Result<void> {
         line.transparent = true;
         return {};
     },
     true},
    {"fibres", " replay sketch render ",
     [](CommandLine& line, const QString&) -> Result<void> {
         line.fibres = true;
         return {};
     },
     true},
    {"ground-shadow", " replay sketch render ",
     [](CommandLine& line, const QString&) -> Result<void> {
         line.groundShadow = true;
         return {};
     },
     true},
    {"stats", " replay sketch ",
     [](CommandLine& line, const QString& value) -> Result<void> {
         line.stats = value;
         return {};
     }},
    {"profiles", " replay ",
     [](CommandLine& line, const QString& value) -> Result<void> {
         line.profiles = value;
         return {};
     }},
    {"strict", " replay ",
     [](CommandLine& line, const QString&) -> Result<void> {
         line.strict = true;
         return {};
     },
     true},
    {"index", " sketch ",
     [](CommandLine& line, const QString& value) -> Result<void> {
         bool isNumber = false;
         line.drawing = value.toInt(&isNumber);
         if (!isNumber || line.drawing < 0)
             return usage(CommandLineText::tr("--index needs a whole number from 0, not \"%1\"").arg(value));
         return {};
     }},
    {"front-only", " sketch ",
     [](CommandLine& line, const QString&) -> Result<void> {
         line.frontOnly = true;
         return {};
     },
     true},
    {"threads", " replay sketch ",
     [](CommandLine& line, const QString& value) -> Result<void> {
         bool isNumber = false;
         line.threads = value.toInt(&isNumber);
         if (!isNumber || line.threads < 1 || line.threads > kMaxThreads)
             return usage(CommandLineText::tr("--threads needs a number from 1 to %1, not \"%2\"")
                              .arg(kMaxThreads)
                              .arg(value));
         return {};
     }},
    {"seed", " replay sketch ",
     [](CommandLine& line, const QString& value) -> Result<void> {
         bool isNumber = false;
         line.seed = value.toULongLong(&isNumber);
         if (!isNumber)
             return usage(
                 CommandLineText::tr("--seed needs a whole number from 0 to 18446744073709551615, not \"%1\"")
                     .arg(value));
         return {};
     }},
    {"vary", " replay export render ",
     [](CommandLine& line, const QString& value) -> Result<void> {
         VaryOperation variation;
         bool isSeed = false;
         bool isAmount = true;
         variation.seed = value.section(QLatin1Char(':'), 0, 0).toULongLong(&isSeed);
         if (value.contains(QLatin1Char(':')))
             variation.amount = value.section(QLatin1Char(':'), 1).toDouble(&isAmount);
         if (!isSeed || !isAmount || !(variation.amount >= VaryOperation::kLeastAmount) ||
             !(variation.amount <= 1.0))
             return usage(
                 CommandLineText::tr("--vary needs a whole number from 0, and after a colon an amount from "
                                     "%1 to 1 if you like, such as 7 or 7:0.5, not \"%2\"")
                     .arg(VaryOperation::kLeastAmount)
                     .arg(value));
         line.variation = variation;
         return {};
     }},
    {"set", " replay sketch export render ",
     [](CommandLine& line, const QString& value) -> Result<void> { return line.overrides.add(value); }},
};

/// Reads the arguments after a verb.
Result<void> parseArguments(CommandLine& line, const QString& verb, const QStringList& arguments)
{
    const QByteArray spaced = ' ' + verb.toLatin1() + ' ';
    std::vector<const Option*> known;
    QCommandLineParser parser;
    for (const Option& option : kOptions) {
        if (!QByteArray(option.verbs).contains(spaced))
            continue;
        known.push_back(&option);
        const QString value = option.isFlag ? QString() : QStringLiteral("value");
        parser.addOption({QString::fromLatin1(option.name), QString(), value});
    }
    // The parser treats the first string as the program's name.
    if (!parser.parse(QStringList{verb} + arguments)) {
        if (const QStringList unknown = parser.unknownOptionNames(); !unknown.isEmpty())
            return usage(
                CommandLineText::tr("%1 has no option %2").arg(verb, Option::dashed(unknown.constFirst())));
        for (const Option* option : known) {
            const QString withValue = option->shown() + QLatin1Char('=');
            if (option->isFlag && std::ranges::any_of(arguments, [&](const QString& argument) {
                    return argument.startsWith(withValue);
                }))
                return usage(CommandLineText::tr("%1 takes no value").arg(option->shown()));
        }
        // Only the last argument has none after it.
        return usage(CommandLineText::tr("%1 needs a value after it").arg(arguments.constLast()));
    }
    for (const Option* option : known) {
        const QString name = QString::fromLatin1(option->name);
        const QStringList values =
            option->isFlag && parser.isSet(name) ? QStringList{{}} : parser.values(name);
        for (const QString& value : values) {
            if (value.isEmpty() && !option->isFlag)
                return usage(CommandLineText::tr("%1 needs a value after it").arg(option->shown()));
            if (const Result<void> taken = option->take(line, value); !taken)
                return taken.error();
        }
    }
    line.inputs = parser.positionalArguments();
    return {};
}

/// Checks that the verb has all inputs and outputs that it needs, and no others.
Result<void> checkComplete(const CommandLine& line)
{
    if (line.transparent && line.picture.isEmpty())
        return usage(CommandLineText::tr("--transparent needs --png FILE"));
    if (line.fibres && line.picture.isEmpty())
        return usage(CommandLineText::tr("--fibres needs --png FILE"));
    if (line.groundShadow && !line.transparent)
        return usage(CommandLineText::tr("--ground-shadow needs --transparent"));
    switch (line.verb) {
    case Verb::Replay:
        if (line.inputs.isEmpty())
            return usage(CommandLineText::tr("replay needs at least one recipe or project"));
        break;
    case Verb::Import:
        if (line.inputs.size() != 1 || line.outputs.isEmpty())
            return usage(CommandLineText::tr("import needs one skeleton and -o OUT"));
        break;
    case Verb::Sketch:
        if (line.inputs.isEmpty())
            return usage(CommandLineText::tr("sketch needs at least one drawing"));
        break;
    case Verb::Export:
    case Verb::Render:
        if (line.inputs.size() != 1)
            return usage(
                CommandLineText::tr("%1 needs one project")
                    .arg(line.verb == Verb::Export ? QStringLiteral("export") : QStringLiteral("render")));
        if (line.verb == Verb::Render && line.picture.isEmpty())
            return usage(CommandLineText::tr("render needs --png FILE"));
        break;
    case Verb::Info:
        if (line.inputs.size() != 1)
            return usage(CommandLineText::tr("info needs one file"));
        break;
    default:
        if (line.inputs.size() > 1)
            return usage(CommandLineText::tr("a window opens only one file; \"%1\" is one too many")
                             .arg(line.inputs[1]));
    }
    return {};
}

/// A line for each export format: "    .glb  Binary glTF".
QString formatList()
{
    QString lines;
    for (const ExportFormat* format : exportFormats())
        lines += QStringLiteral("    .%1  %2\n").arg(format->suffix(), format->name());
    return lines;
}

} // namespace

bool CommandLine::needsDisplay() const
{
    return verb == Verb::Window || verb == Verb::Demo || !picture.isEmpty();
}

Result<CommandLine> parseCommandLine(const QStringList& arguments)
{
    CommandLine line;
    if (arguments.isEmpty())
        return line;

    const QString& first = arguments.constFirst();
    if (first == QStringLiteral("--help") || first == QStringLiteral("-h")) {
        line.verb = Verb::Help;
        return line;
    }
    if (first == QStringLiteral("--version") || first == QStringLiteral("-v")) {
        line.verb = Verb::Version;
        return line;
    }
    QString name = QStringLiteral("espalier");
    qsizetype rest = 1;
    if (first == QStringLiteral("replay"))
        line.verb = Verb::Replay;
    else if (first == QStringLiteral("import"))
        line.verb = Verb::Import;
    else if (first == QStringLiteral("sketch"))
        line.verb = Verb::Sketch;
    else if (first == QStringLiteral("export"))
        line.verb = Verb::Export;
    else if (first == QStringLiteral("render"))
        line.verb = Verb::Render;
    else if (first == QStringLiteral("info"))
        line.verb = Verb::Info;
    else if (first == QStringLiteral("--demo"))
        line.verb = Verb::Demo;
    else
        rest = 0;
    if (rest == 1 && line.verb != Verb::Demo)
        name = first;

    if (const Result<void> parsed = parseArguments(line, name, arguments.mid(rest)); !parsed)
        return parsed.error();
    if (const Result<void> complete = checkComplete(line); !complete)
        return complete.error();
    return line;
}

QString commandLineHelp()
{
    return CommandLineText::tr(
               "Espalier: brush trees into being.\n"
               "\n"
               "espalier [PROJECT]\n"
               "    Opens the window.\n"
               "\n"
               "espalier --demo [RECIPE]\n"
               "    Opens the window and brushes a tree in it; then it is yours.\n"
               "\n"
               "espalier replay RECIPE|PROJECT... [-o OUT]... [--png FILE] [--size WxH]\n"
               "                [--camera front|side|top|three-quarter]\n"
               "                [--transparent [--ground-shadow]] [--fibres]\n"
               "                [--stats FILE] [--profiles FILE] [--threads N] [--seed N]\n"
               "                [--strict] [--vary SEED[:AMOUNT]] [--set GROUP.NAME=VALUE]...\n"
               "    Plays a recipe without a window, and writes the result.\n"
               "    For a project, all that was done to its tree is done again.\n"
               "    With several recipes, each continues the tree of the one before: the\n"
               "    first sets the seed, and each begins by applying its own parameters.\n"
               "    --profiles: the places of the strands in each cross-section, as JSON.\n"
               "    Whatever an operation does not find is printed; with --strict it is an\n"
               "    error, and nothing is written.\n"
               "    --set gives a parameter a value for the whole replay, whatever recipes say:\n"
               "    --set growth.shedding=0.1 --set leaves.visible=false. Angles are in degrees.\n"
               "    --vary makes the tree's angles and lengths deviate a little, by 0.3 or by\n"
               "    an AMOUNT of up to 1; each SEED gives another neighbour in a forest.\n"
               "\n"
               "espalier import SKELETON.csv -o OUT...\n"
               "    Makes a tree from a measured one: each line has id, parent, both ends, radius.\n"
               "\n"
               "espalier sketch DRAWING... [--index N] [--front-only] [-o OUT]... [--png FILE]\n"
               "                [--size WxH] [--camera ...] [--stats FILE] [--seed N]\n"
               "                [--set GROUP.NAME=VALUE]...\n"
               "    Makes a tree from a drawing: lines are branches, small loops are leaves,\n"
               "    a large loop is a crown to grow into. Drawings are SVG, or Quick, Draw!\n"
               "    .ndjson, where --index picks a line, from 0. Several drawings are drawn one\n"
               "    over the other. --front-only: the drawing is placed once, and not a second\n"
               "    time from the side.\n"
               "\n"
               "espalier export PROJECT [-o OUT]... [--vary SEED[:AMOUNT]]\n"
               "                [--set GROUP.NAME=VALUE]...\n"
               "    Writes a project in other formats. --vary and --set change what is written;\n"
               "    the project stays as it is.\n"
               "\n"
               "espalier render PROJECT --png FILE [--size WxH] [--camera ...]\n"
               "                [--transparent [--ground-shadow]] [--fibres]\n"
               "                [--vary SEED[:AMOUNT]] [--set GROUP.NAME=VALUE]...\n"
               "    Draws a picture. It needs a display; a virtual one will do.\n"
               "    --transparent: the tree alone, with straight alpha; --ground-shadow keeps\n"
               "    its shadow, as partly transparent black. --fibres: the strands of the wood.\n"
               "\n"
               "espalier info FILE\n"
               "    Prints as JSON what is in a project.\n"
               "\n"
               "espalier --help, --version\n"
               "\n"
               "OUT ends in .espalier (project) or in the suffix of a format:\n"
               "%1"
               "Exits with 0 when done, 2 when the command line is wrong, 3 when an input is\n"
               "unreadable or wrong, 4 when an output could not be written.\n")
        .arg(formatList());
}

} // namespace espalier
