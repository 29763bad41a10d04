/* The Lua files of scripts/ as strings in the program. The table is generated at build time. */
#ifndef LUA_EMBEDDED_H
#define LUA_EMBEDDED_H

typedef struct embedded_script {
  const char *name; /* module name without "archard.", such as "plot.draw"; NULL ends the list */
  const char *path; /* path of the file, such as "scripts/plot/draw.lua" */
  const char *text;
} embedded_script;

extern const embedded_script embedded_scripts[];

#endif
