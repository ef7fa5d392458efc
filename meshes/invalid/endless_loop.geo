// Counts back in each turn, for ever.
For i In {1:2}
  i = 0;
EndFor
