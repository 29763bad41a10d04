/* Declares names of running programs, which identify the owners of files on shared disks. */
#ifndef CORE_OWNER_H
#define CORE_OWNER_H

/* Size [bytes] of a program's name, including the terminating zero. */
enum { ARC_OWNER = 40 };

/* Writes the name of this program, "SYSTEM-PID". SYSTEM changes when the computer restarts. */
void arc_owner_name(char name[ARC_OWNER]);

typedef enum arc_owner_state {
  ARC_OWNER_GONE,
  ARC_OWNER_LIVES,
  ARC_OWNER_ELSEWHERE /* unknown, because the program is on another computer or the text is not a
                         name */
} arc_owner_state;

/* Reads the name of a program, as arc_owner_name writes it, at the beginning of a text. Returns the
 * state of this program. Characters after the last digit of the PID are ignored. */
arc_owner_state arc_owner_look(const char *name);

#endif
