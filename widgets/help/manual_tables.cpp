#include "widgets/help/manual_tables.h"

#include <QCoreApplication>
#include <QHash>
#include <QLocale>
#include <QStringList>

#include <string_view>

#include "engine/base/parameters.h"
#include "engine/files/path_exporter.h"
#include "engine/operator/device_registry.h"
#include "engine/places/attribute.h"
#include "engine/planning/planner.h"
#include "widgets/controls/diagnostic_text.h"

namespace glissade {
namespace {

struct ManualTables {
  Q_DECLARE_TR_FUNCTIONS(ManualTables)
};

QString htmlOf(const Message& text) { return engineText(text).toHtmlEscaped(); }

QString codeText(std::string_view text) {
  return QStringLiteral("<code>%1</code>").arg(QString::fromUtf8(text.data(), static_cast<int>(text.size())));
}

QString keyText(const QString& keys) {
  return keys.isEmpty() ? QString() : QStringLiteral("<kbd>%1</kbd>").arg(keys.toHtmlEscaped());
}

QString rowOf(const QStringList& cells) {
  QString row;
  for (const QString& cell : cells) row += QStringLiteral("<td>%1</td>").arg(cell);
  return QStringLiteral("<tr>%1</tr>\n").arg(row);
}

/// An HTML table. `sentences`: its widest column, which holds sentences; -1: none.
QString tableOf(const QStringList& header, const QString& rows, int sentences = -1) {
  QString heads;
  for (int i = 0; i < header.size(); ++i) {
    const QString width = i == sentences ? QStringLiteral(" width=\"34%\"") : QString();
    heads += QStringLiteral("<th%1>%2</th>").arg(width, header[i]);
  }
  return QStringLiteral("<div class=\"wide\"><table>\n<tr>%1</tr>\n%2</table></div>\n").arg(heads, rows);
}

/// One table for each menu, in the order of the catalogue.
QString actionTables(const ManualFacts& facts) {
  QStringList menus;
  QHash<QString, QString> rows;
  for (const ManualAction& action : facts.actions) {
    if (!menus.contains(action.menu)) menus << action.menu;
    rows[action.menu] += rowOf({action.text.toHtmlEscaped(), keyText(action.keys), action.tip.toHtmlEscaped(),
                                QStringLiteral("<code>%1</code>").arg(action.id)});
  }
  const QStringList header{ManualTables::tr("Command"), ManualTables::tr("Keys"), ManualTables::tr("What it does"),
                           ManualTables::tr("In scripts")};
  QString html;
  for (const QString& menu : menus) {
    html += QStringLiteral("<h3>%1</h3>\n").arg(menu.toHtmlEscaped()) + tableOf(header, rows[menu], 2);
  }
  return html;
}

QString panelTable(const ManualFacts& facts) {
  QString rows;
  for (const ManualPanel& panel : facts.panels) {
    rows += rowOf(
        {QStringLiteral("<a href=\"panels.html#panel-%1\">%2</a>").arg(panel.id, panel.title), keyText(panel.keys)});
  }
  return tableOf({ManualTables::tr("Panel"), ManualTables::tr("Keys")}, rows);
}

QString number(double value) { return QLocale().toString(value, 'g', 6); }

/// A value of the table with its unit, or as a multiple of the object's radius.
QString valueOf(const ParameterSpec& spec, double value) {
  if (spec.scale == ParameterScale::ObjectRadius) return number(value) + QStringLiteral(" r");
  if (spec.unit.empty()) return number(value);
  return number(value) + QLatin1Char(' ') + QString::fromUtf8(spec.unit.data(), static_cast<int>(spec.unit.size()));
}

QString rangeText(const ParameterSpec& spec) {
  return ManualTables::tr("%1 to %2").arg(valueOf(spec, spec.minimum), valueOf(spec, spec.maximum));
}

QString parameterTableHtml() {
  QString rows;
  for (const ParameterSpec& spec : parameterTable()) {
    const QString symbol =
        spec.symbol.empty() ? QString() : QStringLiteral(" (%1)").arg(QString::fromUtf8(spec.symbol.data()));
    const QString anchor = QStringLiteral("<a name=\"%1\"></a>").arg(QString::fromUtf8(spec.key.data()));
    rows += rowOf({anchor + htmlOf(spec.label) + symbol, htmlOf(spec.help), rangeText(spec),
                   valueOf(spec, spec.defaultValue), spec.live ? ManualTables::tr("yes") : ManualTables::tr("no"),
                   codeText(spec.key)});
  }
  return tableOf({ManualTables::tr("Parameter"), ManualTables::tr("Meaning"), ManualTables::tr("Range"),
                  ManualTables::tr("Default"), ManualTables::tr("During a run"), ManualTables::tr("In files")},
                 rows, 1);
}

QString strategyTable() {
  QString rows;
  const PlannerRegistry planners = makePlannerRegistry();
  for (const PlannerEntry& entry : planners.entries()) {
    rows += rowOf({htmlOf(entry.label), codeText(entry.id), htmlOf(entry.description)});
  }
  return tableOf({ManualTables::tr("Strategy"), ManualTables::tr("In files, on the command line"),
                  ManualTables::tr("What it does")},
                 rows);
}

QString operatorTable() {
  QString rows;
  const DeviceRegistry devices = makeDeviceRegistry();
  for (const DeviceEntry& entry : devices.entries()) {
    rows += rowOf({htmlOf(entry.label), codeText(entry.id), htmlOf(entry.description)});
  }
  return tableOf({ManualTables::tr("Operator"), ManualTables::tr("In files, on the command line"),
                  ManualTables::tr("What it does")},
                 rows);
}

QString attributeTable() {
  QString rows;
  const AttributeTable attributes;
  for (const AttributeDefinition& definition : attributes.definitions()) {
    rows += rowOf({htmlOf(definition.label), codeText(definition.name),
                   definition.owner == AttributeOwner::Place ? ManualTables::tr("place") : ManualTables::tr("body"),
                   htmlOf(definition.description)});
  }
  return tableOf({ManualTables::tr("Attribute"), ManualTables::tr("In files and rules"), ManualTables::tr("Of"),
                  ManualTables::tr("Meaning")},
                 rows);
}

QString pathFormatTable() {
  QString rows;
  const PathExporterRegistry exporters = makePathExporterRegistry();
  for (const PathExporter& exporter : exporters.entries()) {
    QStringList endings;
    for (const std::string& ending : exporter.endings) endings << codeText("." + ending);
    rows += rowOf({htmlOf(exporter.label), endings.join(QStringLiteral(", ")),
                   exporter.readBackError ? ManualTables::tr("yes") : ManualTables::tr("no")});
  }
  return tableOf({ManualTables::tr("Format"), ManualTables::tr("Ending"), ManualTables::tr("Can be read again")}, rows);
}

}  // namespace

QString manualTable(const QString& name, const ManualFacts& facts) {
  if (name == QStringLiteral("actions")) return actionTables(facts);
  if (name == QStringLiteral("panels")) return panelTable(facts);
  if (name == QStringLiteral("parameters")) return parameterTableHtml();
  if (name == QStringLiteral("strategies")) return strategyTable();
  if (name == QStringLiteral("operators")) return operatorTable();
  if (name == QStringLiteral("attributes")) return attributeTable();
  if (name == QStringLiteral("path-formats")) return pathFormatTable();
  if (name == QStringLiteral("steering")) return QStringLiteral("<table>%1</table>").arg(facts.steeringRows);
  return {};
}

}  // namespace glissade
