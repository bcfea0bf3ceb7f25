/* A plug-in, a part of which was not compiled into it. */
namespace probe
{
void Paint(int strokes);
}

extern void (*const paint)(int);
void (*const paint)(int) = &probe::Paint;
