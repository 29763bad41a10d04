/* The Lua files of scripts/, as they stand inside the binary (generated at build time). */
#ifndef LUA_EMBEDDED_H
#define LUA_EMBEDDED_H

typedef struct embedded_script {
  const char *name; /* file name without folder and ending; NULL ends the list */
  const char *text;
} embedded_script;

extern const embedded_script embedded_scripts[];

#endif
